# GLM for another machine: its headers alone, where scripts/determinism has put those that fit any machine.
add_library(glm::glm INTERFACE IMPORTED)
set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${LODESTONE_CROSS_HEADERS})
