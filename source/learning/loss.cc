#include <asperity/learning/loss.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  double
  Loss::evaluate(const std::size_t n,
                 const float      *outputs,
                 const float      *targets,
                 const float       factor,
                 float            *gradient) const
  {
    double sum = 0.;
    if (kind == Kind::squared)
      for (std::size_t i = 0; i < n; ++i)
        {
          const float error = outputs[i] - targets[i];
          sum += double(error) * error;
          gradient[i] = 2.f * factor * error;
        }
    else
      {
        const float d = static_cast<float>(clamp);
        for (std::size_t i = 0; i < n; ++i)
          {
            const float error =
              std::clamp(outputs[i], -d, d) - std::clamp(targets[i], -d, d);
            const float sign = error > 0.f ? factor :
                               error < 0.f ? -factor :
                                             0.f;
            sum += std::abs(error);
            gradient[i] = std::abs(outputs[i]) <= d ? sign : 0.f;
          }
      }
    return sum;
  }
} // namespace asperity
