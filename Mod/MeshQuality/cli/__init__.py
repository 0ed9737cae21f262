# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, one job at a time.

    parser           the arguments, the help and the manual page
    exit_status      what the program ends with
    job_checks       what can be seen of a job without FreeCAD
    freecad_process  FreeCAD's console program: where it is, how it is waited for
    signals          what ends it
    single_job       a job in a FreeCAD of its own
    job              what runs in that, with
    input_files      what its files hold
    output_file      the file that it writes
    progress_line    its progress at a terminal
    report_fields    what it tells of the result
    main             all of it, and `meshquality batch`, which is built on the others

Only `job` and what it has beside it import FreeCAD. The job travels in a file, because FreeCAD's own option parser takes what is on its
command line, and the result comes back in one, because FreeCAD prints to stdout.
"""
