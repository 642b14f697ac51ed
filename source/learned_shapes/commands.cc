#include <asperity/base/errors.h>
#include <asperity/base/folder_lock.h>
#include <asperity/base/parameters.h>
#include <asperity/base/progress.h>
#include <asperity/base/ranks.h>
#include <asperity/learned_shapes/commands.h>
#include <asperity/learned_shapes/shape_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "shape_tables.h"

namespace asperity
{
  namespace
  {
    template <int dim>
    void
    print_plan(const ShapeStudy<dim> &study, const ShapeParameters &parameters)
    {
      const DecoderShape &network = parameters.network;
      const auto          old     = std::cout.precision(3);
      std::cout << study.n_trained() << " shapes to learn, "
                << study.recipes().size() - study.n_trained()
                << " held out; codes of " << network.n_code << ", network of "
                << network.n_layers << " x " << network.width << " with "
                << network.n_parameters() << " weights; " << study.flops()
                << " operations: at 20 Gflop/s a core "
                << format_duration(study.flops() / 2e10) << std::endl;
      std::cout.precision(old);
    }



    template <int dim>
    void
    run(const ShapeParameters &parameters, const Ranks &ranks)
    {
      ShapeStudy<dim> study(parameters, ranks);
      if (ranks.is_first())
        print_plan(study, parameters);
      ShapeResults results;
      {
        ProgressLine progress(std::cout,
                              ranks.is_first() ? ProgressLine::Mode::automatic :
                                                 ProgressLine::Mode::silent);
        results.loss =
          study.train(parameters.directory + "/checkpoint.asperity", progress);
      }
      results.shapes        = study.reconstruct();
      results.interpolation = study.interpolate();
      results.arithmetic    = study.calculate();
      if (!ranks.is_first())
        return;
      std::vector<double> codes;
      for (std::size_t i = 0; i < study.recipes().size(); ++i)
        codes.insert(codes.end(), study.code(i).begin(), study.code(i).end());
      results.places =
        embed_in_plane(codes, parameters.network.n_code, parameters.embedding);
      write_results(study, results, parameters.directory);
      print_results(study, results, std::cout);
      std::cout << "Model, tables and pictures are in " << parameters.directory
                << "\n";
    }
  } // namespace



  int
  learn_shapes(const std::string &file)
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    ShapeParameters          parameters;
    parameters.declare(declarator);
    declarator.read_file(file);
    parameters.check(declarator);

    const Ranks                 ranks = Ranks::together();
    std::unique_ptr<FolderLock> lock;
    if (ranks.is_first())
      lock = std::make_unique<FolderLock>(
        parameters.directory, declarator.where("Output/Output directory"));
    ranks.meet();
    if (parameters.dimension == 2)
      run<2>(parameters, ranks);
    else
      run<3>(parameters, ranks);
    return 0;
  }



  void
  declare_shape_parameters(ParameterDeclarator &parameters)
  {
    static ShapeParameters shapes;
    shapes.declare(parameters);
  }
} // namespace asperity
