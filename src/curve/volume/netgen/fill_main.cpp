// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace nglib {
#include <netgen/nglib.h>
}

/// Fills a closed surface with tetrahedra by Netgen's nglib: a program of its own, because Netgen holds one mesh a
/// process, crashes or does not end on some surfaces, and must not meet the Netgen of some builds of FreeCAD.
///
/// Standard input: two int64, the counts of points and triangles; a double, the factor of the usual grading; the
/// points, three doubles each; the triangles, three int32 each, outward. Standard output: int64 0, the counts of points
/// and tetrahedra, the points, the tetrahedra with four int32 each; or int64 1, a length, and the reason of the
/// failure.
namespace {

/// Growth of tetrahedra away from the surface, 0 to 1. Netgen 6.2.19 makes three times as many in a model with small
/// fillets at its default of 0.3, which are no better. Newer versions, which have this header, put far fewer vertices
/// inside at the same value: at 0.2 they make as many tetrahedra as 6.2.19 did at 0.5, and better ones, at 0.5 slivers.
#if __has_include(<netgen/nglib_occ.h>)
/// Netgen newer than 6.2.19, see above.
constexpr double kGrading = 0.1;
#else
/// Netgen up to 6.2.19, see above.
constexpr double kGrading = 0.5;
#endif

struct Input {
    double grading_factor = 1.0;
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

template <typename T>
bool read(std::vector<T>& list) {
    return std::fread(list.data(), sizeof(T), list.size(), stdin) == list.size();
}

template <typename T>
void write(std::FILE* out, const std::vector<T>& list) {
    std::fwrite(list.data(), sizeof(T), list.size(), out);
}

bool read(Input& input) {
    std::vector<std::int64_t> counts(2);
    if (!read(counts) || std::fread(&input.grading_factor, sizeof input.grading_factor, 1, stdin) != 1) {
        return false;
    }
    input.points.resize(static_cast<std::size_t>(counts[0]));
    input.triangles.resize(static_cast<std::size_t>(counts[1]));
    return read(input.points) && read(input.triangles);
}

/// The program ends when the one that started it ends, by whatever cause: on Linux by a signal of the kernel,
/// everywhere because nobody holds the reading end of its output any more.
void end_with_parent() {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    const int answer = dup(STDOUT_FILENO);
    std::thread([answer] {
        pollfd end{answer, 0, 0};
        while (poll(&end, 1, -1) < 0 && errno == EINTR) {
        }
        // The parent may have ended before the signal was requested.
        if ((end.revents & (POLLERR | POLLHUP)) != 0) {
            _exit(3);
        }
    }).detach();
}

/// Ends the program by a signal when Netgen does not terminate.
void limit_time(std::size_t triangles) {
    const auto seconds = static_cast<rlim_t>(60 + triangles / 100);
    const rlimit limit{seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
}

/// Netgen writes to the standard output: that is discarded, and the answer goes to the original one.
std::FILE* take_output() {
    const int answer = dup(STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    return fdopen(answer, "wb");
}

void write_mesh(std::FILE* out, nglib::Ng_Mesh* mesh) {
    std::vector<std::array<double, 3>> points(static_cast<std::size_t>(nglib::Ng_GetNP(mesh)));
    for (std::size_t i = 0; i < points.size(); ++i) {
        nglib::Ng_GetPoint(mesh, static_cast<int>(i) + 1, points[i].data());
    }
    std::vector<std::array<std::int32_t, 4>> tetrahedra(static_cast<std::size_t>(nglib::Ng_GetNE(mesh)));
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
        int v[NG_VOLUME_ELEMENT_MAXPOINTS];
        nglib::Ng_GetVolumeElement(mesh, static_cast<int>(i) + 1, v);
        tetrahedra[i] = {v[0] - 1, v[1] - 1, v[2] - 1, v[3] - 1};
    }
    write<std::int64_t>(out,
                        {0, static_cast<std::int64_t>(points.size()), static_cast<std::int64_t>(tetrahedra.size())});
    write(out, points);
    write(out, tetrahedra);
}

void write_failure(std::FILE* out, const std::string& why) {
    write<std::int64_t>(out, {1, static_cast<std::int64_t>(why.size())});
    std::fwrite(why.data(), 1, why.size(), out);
}

void fill(const Input& input, std::FILE* out) {
    nglib::Ng_Init();
    nglib::Ng_Mesh* mesh = nglib::Ng_NewMesh();
    for (const auto& p : input.points) {
        double x[3] = {p[0], p[1], p[2]};
        nglib::Ng_AddPoint(mesh, x);
    }
    for (const auto& t : input.triangles) {
        int v[3] = {t[0] + 1, t[1] + 1, t[2] + 1};
        nglib::Ng_AddSurfaceElement(mesh, nglib::NG_TRIG, v);
    }
    nglib::Ng_Meshing_Parameters parameters;
    parameters.maxh = 1e30;
    parameters.grading = kGrading * input.grading_factor;
    const nglib::Ng_Result result = nglib::Ng_GenerateVolumeMesh(mesh, &parameters);
    if (result == nglib::NG_OK && nglib::Ng_GetNE(mesh) > 0) {
        write_mesh(out, mesh);
    } else {
        write_failure(out, "result " + std::to_string(result));
    }
}

}  // namespace

int main() {
    end_with_parent();
    Input input;
    if (!read(input)) {
        return 2;
    }
    limit_time(input.triangles.size());
    std::FILE* out = take_output();
    try {
        fill(input, out);
    } catch (const std::exception& error) {
        write_failure(out, error.what());
    }
    std::fclose(out);
    // Netgen's own clean-up is not needed, and not reliable after a failure.
    _exit(0);
}
