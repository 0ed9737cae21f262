# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates, and what they say in sentences."""
