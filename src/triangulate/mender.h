// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "base/key_set.h"
#include "triangulate/disc.h"
#include "triangulate/insertion.h"
#include "triangulate/region_undo.h"
#include "triangulate/sizing.h"
#include "triangulate/slider.h"
#include "triangulate/triangle_marks.h"

namespace mq::triangulate {

/// Mends triangles below the bound that refinement has given up, by local improvement: the triangles of a disc around
/// one of them (the stars of its corners and edges, itself with its neighbours) give way to a fan from a new vertex, or
/// from one of the rim, when the smallest angle among them becomes larger. So vertices move, edges collapse and
/// vertices are put in, whichever helps most; where that does not do, vertices on CAD edges move along these (Slider).
///
/// Refinement fails where a long edge at a narrow corner of the part has short ones beside it: encroachment forbids the
/// vertices that a graded fan needs. Angles here are all that counts, besides the bounds on lengths and chord heights.
/// Every change lifts the smallest angle of its disc by a least amount, and the number of attempts is limited.
///
/// Where no single change does, a disc is changed for the worse, with a vertex more or less (a fan around a vertex of a
/// CAD edge gets another spoke, a corner loses one), a segment is split, or a vertex moves along its CAD edge, what is
/// around is mended, and all of it is undone unless it ends better. Where that does not help either, another such
/// change follows upon the first.
class Mender {
  public:
    /// What is tried where no single change helps: other fans; ears, splits and moves, too; two of all these in a row.
    enum class Escape { Fans, All, TwoInARow };

    Mender(Workspace& work, double min_angle_degrees, const Sizing& sizing);

    /// Single changes, as long as one helps. @return whether anything was changed, as of all that follow.
    bool change_singly();
    /// Makes what is around bad triangles better than the bound first, where it holds these fast.
    bool make_room_and_change();
    /// Rounds of escapes, and of the former between them, as long as enough becomes better.
    /// @param missing_before that of the round before
    bool run(const std::vector<Escape>& escapes, double missing_before);
    /// What triangles miss of the bound that may have it, radians in all.
    double missing() const;

  private:
    struct Bad {
        double angle;
        int triangle;
        std::uint32_t stamp;
        bool operator<(const Bad& other) const {  // a max-heap: the smallest angle on top, ties by index
            return angle != other.angle ? angle > other.angle : triangle > other.triangle;
        }
    };
    struct Proposal {
        Disc disc;
        int apex_site = -1;  ///< of the rim; -1: a new vertex at `apex`
        Vec3 apex = Vec3::Zero();
        double angle = 0.0;  ///< smallest of the fan
        double before = 0.0;
        int ear_site = -1;  ///< of the rim, to be cut off; -1: none
    };

    /// Fans for a disc that are good enough, and the side over which a larger disc may do better, or -1.
    struct Fan {
        int apex_site = -1;
        Vec3 apex = Vec3::Zero();
        double angle = 0.0;
    };
    struct Found {
        std::vector<Fan> fans;
        double before = 0.0;  ///< the smallest angle of the disc
        int over = -1;
    };

    void want(double angle);
    void push_if_bad(int triangle);
    bool near(int triangle) const;
    void push_all();
    bool work_off();
    std::vector<int> bad_triangles() const;
    void make_room();
    bool hopeless(int triangle) const;
    bool at_resolution(int triangle) const;
    bool mend(int triangle);
    std::vector<Disc> discs_around(int triangle) const;
    const Found& fans_of(const Disc& disc);
    Found search_fans(const Disc& disc) const;
    int propose(const Disc& disc, std::vector<Proposal>& proposals);
    std::vector<Disc> grown(const std::vector<Disc>& discs, const std::vector<int>& over) const;
    bool try_best(std::vector<Proposal>& proposals, double at_least);
    std::optional<SurfacePoint> apex_near(const Disc& disc, const Vec3& p) const;
    bool carry_out(const Proposal& proposal);
    std::vector<int> replace(const Disc& disc, int apex_site);
    bool slide(int triangle);

    /// A change for the worse, to no less than this part of the bound: of a disc, of a segment, or of a vertex's place.
    static constexpr double kLeastOfKick = 0.2;
    struct Kick {
        Proposal fan;
        int segment = -1;
        double fraction = 0.0;  ///< of its parameters, where it is split
        int vertex = -1;        ///< on a CAD edge
        double step = 0.0;      ///< that it moves by, see Slider::angle_after
    };

    // mender_escape.cpp
    bool escape_all(Escape kinds);
    bool spent() const;
    bool first_escape(int triangle);
    bool escape(int triangle, std::size_t depth);
    bool try_kick(const Kick& kick);
    bool better() const;
    bool promising() const;
    int worst_now() const;
    void keep(const Exemption& reason);
    bool move_corner(int triangle);
    bool cut_ear(const std::vector<int>& fan, int ear_site, int apex_site);
    bool reopens_ear(const Disc& disc, int apex_site) const;
    bool reopens_ear(const Disc& disc, int apex_site, int ear) const;
    void follow(const std::function<bool(int)>& change);
    std::vector<Kick> kicks(int triangle) const;
    void add_fans(const Disc& disc, std::vector<Kick>& kicks) const;
    void add_eared_fans(const Disc& disc, std::vector<Kick>& kicks) const;

    // mender_kicks.cpp
    void add_moves(int triangle, std::vector<Kick>& kicks) const;
    bool move(int vertex, double step);
    void add_splits(int triangle, std::vector<Kick>& kicks) const;
    double angle_of_halves(int segment, double fraction) const;
    std::vector<int> segments_around(int triangle) const;
    bool can_be_split(int segment) const;
    bool split(int segment, double fraction);

    void look_again_around(const std::vector<int>& changed);
    double enough_after(double before) const;
    bool good_enough(const Disc& disc, const Corner& apex, int apex_site, double before) const;
    bool near_surface(const Disc& disc, const Corner& apex, const Vec2& uv, int apex_site) const;
    double distance_of_fan(const Disc& disc, const Corner& apex, const Vec2& uv, int apex_site) const;
    double distance_of_disc(const Disc& disc) const;

    Workspace& work_;
    double bound_;                // radians
    double wanted_ = 0.0;         // radians, a little above the bound or, near some vertices, more
    double surely_enough_ = 0.0;  // squared sine, of what is wanted
    std::vector<int> near_;       // these vertices, ascending
    const Sizing& sizing_;
    std::priority_queue<Bad> queue_;
    Slider slider_;
    UndoStack undo_;                          // while it is open whether what is done will be kept
    std::vector<int> ears_;                   // by trial: the site whose ear was cut off, or -1
    std::vector<std::array<int, 2>> splits_;  // of these trials: near and far segments
    TriangleMarks failed_;                    // until something changes beside them
    KeySet tried_to_escape_;
    Escape kinds_ = Escape::Fans;
    std::size_t attempts_left_ = 0;
    double least_aligned_ = kAlignedSwap;
    KeyMap<Found> found_;  // by disc, for what is wanted
    KeySet exhausted_;     // discs that nothing better was found for, by key
};

/// By single changes, and by escapes where these leave something.
/// @return whether anything was changed. Leaves no triangle that is gone.
bool mend(Workspace& work, double min_angle_degrees, const Sizing& sizing);

}  // namespace mq::triangulate
