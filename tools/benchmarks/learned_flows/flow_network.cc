#include <asperity/base/progress.h>
#include <asperity/learning/training.h>

#include <array>
#include <iostream>

#include "flow_learning.h"

namespace learned_flows
{
  namespace
  {
    /** What a network sees of places in the unit box of the flow: x, y and
     *  cos(pi m x), sin(pi m x), the same of y, with m = 1, 2, 4, ... (Tancik
     * et al. 2020). */
    Numbers
    features(const Numbers &positions, const std::array<unsigned int, 2> &waves)
    {
      Numbers        result;
      Point<2>       lower(1e9, 1e9), upper(-1e9, -1e9);
      const unsigned n = positions.size() / 2;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int d = 0; d < 2; ++d)
          {
            lower[d] = std::min(lower[d], positions[2 * i + d]);
            upper[d] = std::max(upper[d], positions[2 * i + d]);
          }
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int d = 0; d < 2; ++d)
          {
            const double x =
              (positions[2 * i + d] - lower[d]) / (upper[d] - lower[d]);
            result.push_back(2. * x - 1.);
            for (unsigned int m = 1; m <= waves[d]; m *= 2)
              for (const double angle : {0., 0.5})
                result.push_back(
                  std::cos(dealii::numbers::PI * (m * x - angle)));
          }
      return result;
    }

    unsigned int
    n_features(const std::array<unsigned int, 2> &waves)
    {
      unsigned int n = 2;
      for (const unsigned int most : waves)
        for (unsigned int m = 1; m <= most; m *= 2)
          n += 2;
      return n;
    }



    /** A network that says velocity and pressure of a code at a place, as
     *  deviations from a mean. */
    struct FlowNetwork
    {
      LearnedFlow::VelocityNodes velocity;
      LearnedFlow::PressureNodes pressure;
      Numbers                    at_velocity, at_pressure; ///< features
      Numbers                    mean;
      AutoDecoder                network;

      Numbers
      decode(const Numbers &z) const
      {
        const std::vector<float> code(z.begin(), z.end());
        Numbers                  u    = mean;
        const Numbers            at_u = network.evaluate(code, at_velocity),
                      at_p            = network.evaluate(code, at_pressure);
        for (std::size_t i = 0; i < velocity.u.size(); ++i)
          {
            u[velocity.u[i]] += at_u[3 * i];
            u[velocity.v[i]] += at_u[3 * i + 1];
          }
        for (std::size_t i = 0; i < pressure.p.size(); ++i)
          u[pressure.p[i]] += at_p[3 * i + 2];
        return u;
      }

      FieldSample
      sample(const LearnedFlow &flow, const Numbers &solution) const
      {
        const Numbers deviation = difference(solution, mean);
        const Numbers p         = flow.pressure_at_velocity_nodes(deviation);
        FieldSample   result{"flow", at_velocity, {}};
        for (std::size_t i = 0; i < velocity.u.size(); ++i)
          for (const double value :
               {deviation[velocity.u[i]], deviation[velocity.v[i]], p[i]})
            result.values.push_back(value);
        return result;
      }
    };



    AutoDecoder
    train(const std::vector<FieldSample> &samples,
          const unsigned int              n_codes,
          const unsigned int              n_epochs,
          const unsigned int              n_features)
    {
      DecoderShape shape;
      shape.n_code     = n_codes;
      shape.n_position = n_features;
      shape.n_outputs  = 3;
      shape.activation = Activation::softplus;
      shape.output     = Activation::identity;
      TrainingOptions options;
      options.n_epochs            = n_epochs;
      options.samples_per_batch   = 8;
      options.points_per_sample   = 512;
      options.loss.kind           = Loss::Kind::squared;
      options.code_regularization = 1e-6;
      options.weights             = {5e-3, 0.5, std::max(1u, n_epochs / 6)};
      options.codes               = {1e-2, 0.5, std::max(1u, n_epochs / 6)};
      AutoDecoderTraining training(shape,
                                   options,
                                   samples,
                                   Scaling(n_features),
                                   scaling_of_values(samples, 3));
      ProgressLine        progress(std::cerr);
      training.run("", progress);
      return training.model();
    }
  } // namespace



  FlowDecoder
  FlowStudy::network(const unsigned int n, const unsigned int n_epochs) const
  {
    auto learnt         = std::make_shared<FlowNetwork>();
    learnt->velocity    = flow.velocity_nodes();
    learnt->pressure    = flow.pressure_nodes();
    learnt->at_velocity = features(learnt->velocity.positions, flow.waves());
    learnt->at_pressure = features(learnt->pressure.positions, flow.waves());
    learnt->mean        = modes->mean();
    std::vector<FieldSample> samples;
    for (std::size_t i = 0; i < all.solutions.size(); ++i)
      if (!is_held_out(i))
        samples.push_back(learnt->sample(flow, all.solutions[i]));
    learnt->network = train(samples, n, n_epochs, n_features(flow.waves()));
    const LearnedFlow *of = &flow;
    return {"network",
            n,
            [learnt](const Numbers &z) { return learnt->decode(z); },
            [learnt, of](const Numbers &u) {
              Loss loss;
              loss.kind = Loss::Kind::squared;
              CodeSearch search;
              search.n_steps         = 300;
              search.points_per_step = 256;
              search.regularization  = 0.;
              const auto code        = infer_code(learnt->network,
                                           learnt->sample(*of, u),
                                           loss,
                                           search);
              return Numbers(code.begin(), code.end());
            }};
  }
} // namespace learned_flows
