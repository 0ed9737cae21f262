// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

/// What the core asks of the operating system beyond the C++ library: posix.cpp is for Linux and macOS, windows.cpp for
/// Windows, and nothing else includes a header of a system's.
namespace mq {

/// Processor seconds of this process, all threads; with POSIX also of the child processes that it has waited for.
double cpu_seconds();

/// Memory for large arrays, in pages of the system's: given back as soon as it is freed, whereas an allocator may keep
/// it. With Linux, blocks of 16 MB and more are in large pages, which make random access faster.
/// @throws std::bad_alloc
void* allocate_block(std::size_t bytes);
/// Gives a block back; `bytes` as when it was taken.
void free_block(void* block, std::size_t bytes) noexcept;
/// Returns freed memory that the allocator keeps to the system, so that the following work can use it.
void release_freed_memory();

/// Has these called in every fork of the process: `before` it, after it `in_parent` and `in_child`; null: nothing.
/// Other threads do not exist in the child. Windows has no forks.
void at_fork(void (*before)(), void (*in_parent)(), void (*in_child)());

/// Has `call` called when the process exits, while its threads still run. Windows ends them first: nothing is called.
void at_exit(void (*call)());
/// Has `call` called when this thread ends. Where it is the one that exits the process, that is before any static
/// object is destroyed ([basic.start.term]); those that are made after a call of at_exit, for example within a function
/// of a library, are destroyed before its `call`. One call a thread. Windows: see at_exit.
void at_thread_end(void (*call)());
/// In a call of at_exit or at_thread_end: the process ends with its status, but without destructors of static objects.
/// With the GNU C library only.
void skip_destructors();

/// Opens a file to write bytes to it. @param path  UTF-8 @return null, and errno, where it cannot be opened
std::FILE* open_for_writing(const std::string& path);

/// The address of a symbol in a library that the process has loaded and keeps from now on.
/// @param path  UTF-8 @return null where the library is not loaded, or has no such symbol
void* symbol_of_library(const std::string& path, const char* name);

}  // namespace mq
