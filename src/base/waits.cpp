// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/waits.h"

#include <map>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq {

namespace {

struct Watched {
    std::mutex mutex;
    std::map<const Progress*, Waits*> operations;
};

Watched& watched() {
    // Never deleted: operations may still run while the process exits.
    static Watched& instance = *new Watched();
    return instance;
}

}  // namespace

void Progress::refuse() {
    throw Cancelled(phrases::kCancelled);
}

Waits::Waits(const Progress& progress, std::string title) : progress_(progress), title_(std::move(title)) {
    Watched& all = watched();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.operations[&progress_] = this;
}

Waits::~Waits() {
    Watched& all = watched();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.operations.erase(&progress_);
}

Message Waits::lasting(std::chrono::steady_clock::duration least) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::chrono::steady_clock::now() - since_ < least ? Message() : what_;
}

std::vector<std::pair<std::string, Message>> Waits::all_lasting(std::chrono::steady_clock::duration least) {
    std::vector<std::pair<std::string, Message>> found;
    Watched& all = watched();
    const std::lock_guard<std::mutex> lock(all.mutex);
    for (const auto& [progress, waits] : all.operations) {
        if (Message what = waits->lasting(least); !what.empty()) {
            found.emplace_back(waits->title_, std::move(what));
        }
    }
    return found;
}

std::string Waits::title_of(const Progress* progress) {
    Watched& all = watched();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const auto found = all.operations.find(progress);
    return found == all.operations.end() ? std::string() : found->second->title_;
}

void Waits::set(const Progress* progress, Message what) {
    Watched& all = watched();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const auto found = all.operations.find(progress);
    if (found == all.operations.end()) {
        return;
    }
    Waits& waits = *found->second;
    const std::lock_guard<std::mutex> lock_of_text(waits.mutex_);
    if (!(waits.what_ == what)) {
        waits.what_ = std::move(what);
        waits.since_ = std::chrono::steady_clock::now();
    }
}

OpenCascadeWait::OpenCascadeWait(const Progress* progress, Message doing) : progress_(progress) {
    Waits::set(progress_, Message{phrases::kWaitsForKernel, {{"stage", std::move(doing)}}});
}

}  // namespace mq
