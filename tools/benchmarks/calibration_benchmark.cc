// How much of other runs the 95 % interval of a friction law holds, for
// functions that are known everywhere:
//
//   calibration_benchmark
//
// prints the tables of tools/benchmarks/README.md.

#include <surrogate/calibration_example.h>

#include <iomanip>
#include <iostream>

namespace
{
  using namespace calibration_example;

  void
  print(const Quality &quality)
  {
    std::cout << " | " << std::setprecision(3) << 100. * quality.coverage
              << " % | " << std::setprecision(2) << 100. * quality.error
              << " %";
  }



  void
  random_runs()
  {
    std::cout << "| training points | noise | dry: in the band | error | "
                 "lubricated: in the band | error |\n"
                 "| --- | --- | --- | --- | --- | --- |\n";
    for (const std::size_t n : {80, 110, 150})
      for (const double noise : {0., 0.002, 0.01})
        {
          std::cout << "| " << n << " | " << 100. * noise << " %";
          for (const auto &truth : {dry, lubricated})
            print(judge(truth, noise, n, everything));
          std::cout << " |\n";
        }
  }



  void
  slabs()
  {
    std::cout << "\n| slab | dry: in the band | error | lubricated: in the "
                 "band | error |\n| --- | --- | --- | --- | --- |\n";
    const std::vector<std::string> names = {
      "p low", "p high", "v low", "v high", "T low", "T high"};
    for (unsigned int face = 0; face < names.size(); ++face)
      {
        std::cout << "| " << names[face];
        for (const auto &truth : {dry, lubricated})
          print(judge(truth, 0.002, 110, [face](const double *z) {
            return is_off_face(face, z);
          }));
        std::cout << " |\n";
      }
  }
} // namespace



int
main()
{
  random_runs();
  slabs();
}
