#ifndef asperity_learned_shapes_boundary_mesh_h
#define asperity_learned_shapes_boundary_mesh_h

#include <asperity/learned_shapes/shape.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <vector>

namespace asperity
{
  /**
   * A body given by its surface: the segments of polygons in the plane, the
   * triangles of a surface in space. Segments run counterclockwise around the
   * body, triangles seen from outside.
   *
   * Distances are exact. Their sign is that of the angle-weighted pseudonormal
   * at the closest point (Baerentzen and Aanaes 2005), which is right wherever
   * the surface is closed and does not cut itself.
   */
  template <int dim>
  class BoundaryMesh : public Shape<dim>
  {
  public:
    using Simplex = std::array<unsigned int, dim>;

    /** @throws InputError if there are no simplices, or one of them has no
     *   vertex of that number */
    BoundaryMesh(const std::vector<dealii::Point<dim>> &vertices,
                 const std::vector<Simplex>            &simplices);

    BoundaryMesh(BoundaryMesh &&) noexcept;

    BoundaryMesh &
    operator=(BoundaryMesh &&) noexcept;

    ~BoundaryMesh() override;

    const std::vector<dealii::Point<dim>> &
    vertices() const
    {
      return vertices_;
    }

    const std::vector<Simplex> &
    simplices() const
    {
      return simplices_;
    }

    double
    signed_distance(const dealii::Point<dim> &point) const override;

    dealii::Point<dim>
    surface_point(RandomNumbers &random) const override;

    /** Enclosed area [m2] or volume [m3]. */
    double
    measure() const;

    /** Length [m] or area [m2] of the surface. */
    double
    surface_measure() const
    {
      return cumulative_measure.back();
    }

    /** Whether it is water-tight: the next simplex begins wherever one ends. */
    bool
    is_closed() const;

    /** Of the body, if closed: the number of its parts minus that of holes
     *  through them (in the plane: in them). In space half of that of the
     *  surface, vertices - edges + triangles. */
    int
    euler_number() const;

  private:
    struct Closest;
    struct Tree;

    dealii::Tensor<1, dim>
    scaled_normal(const Simplex &simplex) const;

    void
    add_pseudonormals();

    Closest
    closest(const dealii::Point<dim> &point) const;

    std::vector<dealii::Point<dim>>     vertices_;
    std::vector<Simplex>                simplices_;
    std::vector<double>                 cumulative_measure;
    std::vector<dealii::Tensor<1, dim>> vertex_normals;

    std::unique_ptr<const Tree> tree;
  };

  /** The polygon through these points, counterclockwise. */
  BoundaryMesh<2>
  polygon(const std::vector<dealii::Point<2>> &points);
} // namespace asperity

#endif
