// Flows from latent codes: the vortex street DFG 2D-2 over its phase and the
// lid cavity over the Reynolds number, by modes, by modes of which a network
// says all but the first, and by a network of code and place.
//
//   ninja learned_flows, then learned_flows street|cavity FOLDER [EPOCHS]
//
// Snapshots are computed once, and kept in FOLDER.

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "learned_flows/flow_learning.h"

using namespace learned_flows;

namespace
{
  int
  learn(LearnedFlow       &flow,
        const std::string &folder,
        const unsigned int n_epochs)
  {
    std::filesystem::create_directories(folder);
    const std::string path = folder + "/" + flow.name() + ".h5";
    if (!std::filesystem::exists(path))
      flow.compute().write(path);
    const FlowStudy study(flow, FlowSnapshots::read(path));
    study.print_singular_values();
    std::vector<FlowDecoder> decoders;
    for (const unsigned int n : {2, 4, 8})
      decoders.push_back(study.pod(n));
    for (const unsigned int n : {2, 4, 8})
      decoders.push_back(study.manifold(n));
    if (n_epochs > 0)
      for (const unsigned int n : {2, 4, 8})
        decoders.push_back(study.network(n, n_epochs));
    study.print_head();
    for (const FlowDecoder &decoder : decoders)
      study.print_judgement(decoder);
    std::vector<FlowDecoder> of_two;
    for (const FlowDecoder &decoder : decoders)
      if (decoder.n_codes == 2)
        of_two.push_back(decoder);
    study.write_fields(folder + "/" + flow.name() + "_fields.csv", of_two);
    return 0;
  }
} // namespace

int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession mpi(argc, argv);
  const std::string          which = argc > 2 ? argv[1] : "";
  if (which != "street" && which != "cavity")
    {
      std::fprintf(stderr,
                   "usage: learned_flows street|cavity FOLDER [EPOCHS of the "
                   "network, 0: none]\n");
      return 2;
    }
  const auto flow = which == "street" ? make_street() : make_cavity();
  return learn(*flow, argv[2], argc > 3 ? std::atoi(argv[3]) : 1500);
}
