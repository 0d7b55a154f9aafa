#pragma once
/// On which side: signs of determinants, exact for all finite inputs, denormals and the largest doubles included (C14).
/// A double evaluation with a proven bound on its error decides most cases (Shewchuk, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates", 1997, sec. 4); integers of any length decide the
/// others.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lode::geometry {

/// +1 if a, b, c turn counter-clockwise (y up), −1 clockwise, 0 if they are collinear: the sign of
/// (b − a) × (c − a). All coordinates finite (checked: std::logic_error).
[[nodiscard]] int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// +1 if d lies on the side of the plane abc from which a, b, c are seen counter-clockwise, −1 on the other, 0 in the
/// plane: the sign of ((b − a) × (c − a)) · (d − a). All coordinates finite (checked: std::logic_error).
[[nodiscard]] int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// On which side of a plane that is given by two directions, those of ab and cd, and goes through a: the sign of
/// ((b − a) × (d − c)) · (p − a). 0 for every p if they are parallel. All coordinates finite (checked:
/// std::logic_error).
[[nodiscard]] int side_of_directions(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                                     const glm::dvec3& p);

}  // namespace lode::geometry
