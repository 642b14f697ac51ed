// How fast networks are trained on one core or, with mpirun, on several: what
// the time of a training is foretold by.
//
//   ninja training_speed, then mpirun -np 2 training_speed in its folder

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/learning/training.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace asperity;

namespace
{
  /** Seconds that an epoch of some samples takes. */
  double
  time_of_epoch(AutoDecoderTraining &training)
  {
    using Clock = std::chrono::steady_clock;
    training.run_epoch();
    const auto   begin   = Clock::now();
    unsigned int n       = 0;
    double       elapsed = 0.;
    // all ranks have to take as many
    for (; n < 5; ++n)
      training.run_epoch();
    elapsed = std::chrono::duration<double>(Clock::now() - begin).count();
    return elapsed / n;
  }
} // namespace

int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  const MpiSession         mpi(argc, argv);
  const Ranks              ranks = Ranks::together();
  std::vector<FieldSample> samples(32);
  for (FieldSample &sample : samples)
    for (unsigned int i = 0; i < 1000; ++i)
      {
        sample.positions.push_back(std::cos(i));
        sample.positions.push_back(std::sin(3. * i));
        sample.values.push_back(0.1 * std::sin(i));
      }
  TrainingOptions options;
  for (const unsigned int width : {32, 64, 128, 256})
    for (const Activation activation : {Activation::relu,
                                        Activation::tanh,
                                        Activation::softplus,
                                        Activation::sine})
      {
        DecoderShape shape;
        shape.width      = width;
        shape.activation = activation;
        AutoDecoderTraining training(
          shape, options, samples, Scaling(2), Scaling(1), ranks);
        const double seconds = time_of_epoch(training);
        const double points  = samples.size() * options.points_per_sample;
        if (ranks.is_first())
          std::printf("4 x %3u %-8s %5.1f Gflop/s, %5.2f us a point\n",
                      width,
                      name_of(activation).c_str(),
                      training.flops_per_epoch() / seconds * 1e-9,
                      seconds / points * 1e6);
      }
  return 0;
}
