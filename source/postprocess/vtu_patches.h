#ifndef asperity_postprocess_vtu_patches_h
#define asperity_postprocess_vtu_patches_h

#include <asperity/base/errors.h>
#include <asperity/base/text.h>

#include <deal.II/base/data_out_base.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace asperity
{
  namespace internal
  {
    /** @throws ComputationError unless a field has a value for each point
     *  @param what "line" */
    inline void
    check_size(const std::string &what,
               const std::string &name,
               const std::size_t  n_values,
               const std::size_t  n_points)
    {
      if (n_values != n_points)
        throw ComputationError("The field " + quoted_name(name) + " of a " +
                               what + " has " + std::to_string(n_values) +
                               " values, but the " + what + " has " +
                               std::to_string(n_points) + " points.");
    }



    inline dealii::DataOutBase::VtkFlags
    vtu_flags()
    {
      dealii::DataOutBase::VtkFlags flags;
      // Equal states give equal files.
      flags.print_date_and_time = false;
      flags.compression_level   = dealii::DataOutBase::VtkFlags::best_speed;
      return flags;
    }



    /**
     * The rows of a deal.II patch and their names: fields first, vectors as a
     * row for each component, at the end the coordinates (which deal.II reads
     * as such if points_are_available).
     */
    template <int spacedim>
    class PatchRows
    {
    public:
      void
      add_scalar(const std::string &name)
      {
        names.push_back(name);
        row_fields.push_back(name);
      }

      void
      add_vector(const std::string &name)
      {
        using namespace dealii::DataComponentInterpretation;
        ranges.emplace_back(names.size(),
                            names.size() + spacedim - 1,
                            name,
                            component_is_part_of_vector);
        for (unsigned int c = 0; c < spacedim; ++c)
          {
            names.push_back(name + " " + "xyz"[c]);
            row_fields.push_back(name);
          }
      }

      unsigned int
      n_fields() const
      {
        return names.size();
      }

      /** A patch for these rows with n_points values each. */
      template <int dim>
      dealii::DataOutBase::Patch<dim, spacedim>
      make_patch(const unsigned int n_subdivisions,
                 const unsigned int n_points) const
      {
        dealii::DataOutBase::Patch<dim, spacedim> patch;
        patch.n_subdivisions       = n_subdivisions;
        patch.points_are_available = true;
        patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim>();
        patch.data.reinit(n_fields() + spacedim, n_points);
        return patch;
      }

      /** VTU holds single precision, so that is where numbers must be finite.
       */
      template <int dim>
      void
      require_finite(
        const dealii::DataOutBase::Patch<dim, spacedim> &patch) const
      {
        for (unsigned int row = 0; row < patch.data.n_rows(); ++row)
          for (unsigned int i = 0; i < patch.data.n_cols(); ++i)
            if (!std::isfinite(static_cast<float>(patch.data(row, i))))
              throw ComputationError(
                "The field " +
                quoted_name(row < n_fields() ? row_fields[row] :
                                               "position [m]") +
                " holds a number that is not finite; no picture was "
                "written.");
      }

      template <int dim>
      void
      write(
        const std::vector<dealii::DataOutBase::Patch<dim, spacedim>> &patches,
        const double                                                  time,
        const unsigned int                                            step,
        std::ostream                                                 &out) const
      {
        dealii::DataOutBase::write_vtu_header(out, vtu_flags());
        write_piece(patches, time, step, out);
        dealii::DataOutBase::write_vtu_footer(out);
      }

      /** What stands between head and foot of a VTU file, which has as many of
       *  these as it likes. */
      template <int dim>
      void
      write_piece(
        const std::vector<dealii::DataOutBase::Patch<dim, spacedim>> &patches,
        const double                                                  time,
        const unsigned int                                            step,
        std::ostream                                                 &out) const
      {
        for (const auto &patch : patches)
          require_finite(patch);
        auto flags  = vtu_flags();
        flags.time  = time;
        flags.cycle = step;
        dealii::DataOutBase::write_vtu_main(patches, names, ranges, flags, out);
      }

    private:
      std::vector<std::string> names;
      /** The field of each row, for messages. */
      std::vector<std::string> row_fields;
      std::vector<std::tuple<
        unsigned int,
        unsigned int,
        std::string,
        dealii::DataComponentInterpretation::DataComponentInterpretation>>
        ranges;
    };
  } // namespace internal
} // namespace asperity

#endif
