#ifndef sandglass_tests_all_settings_h
#define sandglass_tests_all_settings_h

#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/particle_in_cell/setting.h>

#include <gtest/gtest.h>

/// The kinematics and cell types of the section, for typed tests.
using AllSettings = testing::Types<
  Sandglass::Setting<Sandglass::PlaneStrain, Sandglass::CellType::triangle>,
  Sandglass::Setting<Sandglass::PlaneStrain,
                     Sandglass::CellType::quadrilateral>,
  Sandglass::Setting<Sandglass::Axisymmetric, Sandglass::CellType::triangle>,
  Sandglass::Setting<Sandglass::Axisymmetric,
                     Sandglass::CellType::quadrilateral>>;

#endif
