// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/cells/tetrahedralisation.h"

#include <algorithm>
#include <utility>

#include "base/key_set.h"

namespace mq::tetrahedralise {

namespace {

std::array<int, 3> face_of(const Cell& cell, int face) {
    std::array<int, 3> key{cell.v[kFaceOf[face][0]], cell.v[kFaceOf[face][1]], cell.v[kFaceOf[face][2]]};
    if (key[0] > key[1]) {
        std::swap(key[0], key[1]);
    }
    if (key[1] > key[2]) {
        std::swap(key[1], key[2]);
    }
    if (key[0] > key[1]) {
        std::swap(key[0], key[1]);
    }
    return key;
}

}  // namespace

int Tetrahedralisation::add_point(const Vec3& point) {
    points.push_back(point);
    at_vertex_.push_back(-1);
    return static_cast<int>(points.size()) - 1;
}

int Tetrahedralisation::new_cell(const std::array<int, 4>& v) {
    int cell = static_cast<int>(cells.size());
    if (free_.empty()) {
        cells.emplace_back();
        goes_.push_back(0);
    } else {
        cell = free_.back();
        free_.pop_back();
    }
    cells[cell].v = v;
    cells[cell].n = {-1, -1, -1, -1};
    for (const int k : v) {
        at_vertex_[k] = cell;
    }
    return cell;
}

void Tetrahedralisation::prepare_table(std::size_t faces) {
    std::size_t size = 64;
    while (size < 2 * faces) {
        size *= 2;
    }
    if (table_.size() < size) {
        table_.assign(size, Open{{-1, -1, -1}, -1, -1, 0});
        round_ = 0;
    }
    ++round_;
}

void Tetrahedralisation::meet(int cell, int face) {
    const std::array<int, 3> key = face_of(cells[cell], face);
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = KeyHash()(key) & mask;
    while (table_[slot].round == round_) {
        Open& open = table_[slot];
        if (open.key == key) {
            cells[cell].n[face] = open.cell;
            cells[open.cell].n[open.face] = cell;
            return;
        }
        slot = (slot + 1) & mask;
    }
    table_[slot] = {key, cell, face, round_};
}

void Tetrahedralisation::replace(const std::vector<int>& removed, const std::vector<std::array<int, 4>>& added,
                                 std::vector<int>& created) {
    prepare_table(4 * (removed.size() + added.size()));
    for (const int c : removed) {
        goes_[c] = 1;
    }
    for (const int c : removed) {
        for (const int other : cells[c].n) {
            if (other >= 0 && goes_[other] == 0) {
                const int face = face_towards(other, c);
                cells[other].n[face] = -1;
                meet(other, face);
                for (int k = 0; k < 3; ++k) {
                    at_vertex_[cells[other].v[kFaceOf[face][k]]] = other;
                }
            }
        }
    }
    for (const int c : removed) {
        goes_[c] = 0;
        cells[c].v = {-1, -1, -1, -1};
        free_.push_back(c);
    }
    created.clear();
    for (const auto& v : added) {
        const int cell = new_cell(v);
        created.push_back(cell);
        for (int face = 0; face < 4; ++face) {
            meet(cell, face);
        }
    }
}

void Tetrahedralisation::star(int v, std::vector<int>& found, std::vector<char>& seen) const {
    found.clear();
    if (at_vertex_[v] < 0 || !has(at_vertex_[v], v)) {
        return;
    }
    seen.resize(cells.size(), 0);
    found.push_back(at_vertex_[v]);
    seen[at_vertex_[v]] = 1;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Cell& cell = cells[found[i]];
        for (int k = 0; k < 4; ++k) {
            const int other = cell.n[k];
            if (cell.v[k] != v && other >= 0 && seen[other] == 0) {
                seen[other] = 1;
                found.push_back(other);
            }
        }
    }
    for (const int c : found) {
        seen[c] = 0;
    }
}

int Tetrahedralisation::cell_with(int a, int b) const {
    star(a, queue_);
    for (const int c : queue_) {
        if (has(c, b)) {
            return c;
        }
    }
    return -1;
}

int Tetrahedralisation::cell_with(int a, int b, int c) const {
    star(a, queue_);
    for (const int cell : queue_) {
        if (has(cell, b) && has(cell, c)) {
            return cell;
        }
    }
    return -1;
}

bool Tetrahedralisation::ring(int a, int b, EdgeRing& found) const {
    const int first = cell_with(a, b);
    return first >= 0 && ring(first, a, b, found);
}

bool Tetrahedralisation::ring(int first, int a, int b, EdgeRing& found) const {
    found.cells.clear();
    found.x.clear();
    int cell = first;
    // The face opposite a, turned so that it begins with b: (b, y, x) is positive seen from a, so that (a, b, x, y) is.
    const int(&face)[3] = kFaceOf[index_of(cell, a)];
    int x = -1;
    int y = -1;
    for (int r = 0; r < 3; ++r) {
        if (cells[cell].v[face[r]] == b) {
            y = cells[cell].v[face[(r + 1) % 3]];
            x = cells[cell].v[face[(r + 2) % 3]];
        }
    }
    do {
        found.cells.push_back(cell);
        found.x.push_back(x);
        const int next = cells[cell].n[index_of(cell, x)];
        if (next < 0) {
            return false;
        }
        const Cell& c = cells[next];
        x = y;
        for (const int v : c.v) {
            if (v != a && v != b && v != x) {
                y = v;
                break;
            }
        }
        cell = next;
    } while (cell != first);
    return true;
}

}  // namespace mq::tetrahedralise
