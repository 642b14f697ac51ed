#include <asperity/learned_fields/field_modes.h>

#include <deal.II/lac/lapack_templates.h>

namespace asperity
{
  unsigned int
  FieldModes::n_modes() const
  {
    return mean.empty() ? 0 : modes.size() / mean.size();
  }



  const double *
  FieldModes::mode(const unsigned int k) const
  {
    return &modes[k * mean.size()];
  }



  std::vector<double>
  FieldModes::combine(const std::vector<double> &coefficients) const
  {
    std::vector<double> values = mean;
    // A matrix with a column a mode. BLAS reads several of them at a time, and
    // a core waits for the memory a third as long as in a loop over one.
    const dealii::types::blas_int length = mean.size(), n = n_modes(), step = 1;
    const double                  one = 1.;
    if (n > 0)
      dealii::gemv("N",
                   &length,
                   &n,
                   &one,
                   modes.data(),
                   &length,
                   coefficients.data(),
                   &step,
                   &one,
                   values.data(),
                   &step);
    return values;
  }



  std::vector<FieldForces>
  forces_of(const FieldLayout &layout, const std::vector<double> &values)
  {
    const FieldSnapshots    &about = layout.about();
    std::vector<FieldForces> result(layout.n_times());
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        const auto fields  = layout.unpack(values, i);
        result[i].traction = force_of_tractions(about, fields);
        if (about.is_quasi_static)
          result[i].imbalance = imbalance_of_stress(about, fields);
      }
    return result;
  }



  ForcesOfModes::ForcesOfModes(const FieldLayout &layout,
                               const FieldModes  &modes)
    : mean(forces_of(layout, modes.mean))
  {
    for (unsigned int k = 0; k < modes.n_modes(); ++k)
      this->modes.push_back(forces_of(
        layout,
        std::vector<double>(modes.mode(k), modes.mode(k) + modes.mean.size())));
  }



  std::vector<FieldForces>
  ForcesOfModes::combine(const std::vector<double> &coefficients) const
  {
    std::vector<FieldForces> result = mean;
    for (std::size_t k = 0; k < modes.size(); ++k)
      for (std::size_t time = 0; time < result.size(); ++time)
        for (unsigned int i = 0; i < 2; ++i)
          {
            const FieldForces &mode = modes[k][time];
            result[time].traction[i] += coefficients[k] * mode.traction[i];
            result[time].imbalance[i] += coefficients[k] * mode.imbalance[i];
          }
    return result;
  }
} // namespace asperity
