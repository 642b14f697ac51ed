// Parsed once for all rooms that rest on deal.II, see Rooms.cmake. Sources
// include what they use all the same.
#include <deal.II/base/parameter_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>

#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>
