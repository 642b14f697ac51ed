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
            const float target = std::clamp(targets[i], -d, d);
            // beyond the clamp on the target's side every output is right
            const float error = target == d  ? std::min(outputs[i] - d, 0.f) :
                                target == -d ? std::max(outputs[i] + d, 0.f) :
                                               outputs[i] - target;
            const float sign  = error > 0.f ? factor :
                                error < 0.f ? -factor :
                                              0.f;
            sum += std::abs(error);
            gradient[i] = sign;
          }
      }
    return sum;
  }
} // namespace asperity
