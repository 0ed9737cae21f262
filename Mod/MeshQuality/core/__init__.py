# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes without a document: what scripts call, what they take and what they return."""
