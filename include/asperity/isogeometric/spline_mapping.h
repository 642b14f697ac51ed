#ifndef asperity_isogeometric_spline_mapping_h
#define asperity_isogeometric_spline_mapping_h

#include <asperity/isogeometric/spline_space.h>

#include <deal.II/fe/mapping_q_cache.h>

#include <memory>

namespace asperity
{
  /**
   * The geometry as a deal.II mapping of space.triangulation(): exact on active
   * cells, where a spline is a polynomial of the space's degree (the mapping
   * has this degree, but at least 2); on refined cells it interpolates. deal.II
   * drops the cached points when the triangulation changes; make a new mapping
   * then.
   * @param geometry the reference geometry, or with the displacement
   *   coefficients added to its offset the deformed one
   */
  std::unique_ptr<dealii::MappingQCache<2>>
  make_mapping(const SplineSpace &space, const PatchGeometry &geometry);
} // namespace asperity

#endif
