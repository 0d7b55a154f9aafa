#pragma once
/// The viewing angle of an object: the direction from it towards the eye (Ohno et al., "Fast 3-D rendering by reusing
/// 2-D images"). Not the angle that it subtends: walking straight up to an object leaves its viewing angle as it is.

#include <cstdint>
#include <glm/vec3.hpp>

namespace lode::techniques {

/// What of a direction counts. full: all of it; yaw: what is seen from above, for walks at one height.
enum class AngleRule : std::uint8_t { full, yaw };

/// The unit vector from the centre of an object to the eye; with `yaw` its part in the horizontal plane, if there is
/// one. The zero vector where the two are in one place.
[[nodiscard]] glm::dvec3 viewing_direction(const glm::dvec3& centre, const glm::dvec3& eye, AngleRule rule);

/// 4·sin²(Δ/2) of the angle Δ between unit vectors: grows with Δ, keeps its digits where Δ is small, and needs no
/// function whose last bits differ between machines. Larger than any angle's if one of the two is no direction.
[[nodiscard]] double angle_measure(const glm::dvec3& a, const glm::dvec3& b);

/// The same of an angle. 0…180°
[[nodiscard]] double angle_measure(double angle_deg);

}  // namespace lode::techniques
