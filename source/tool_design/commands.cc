#include <asperity/base/errors.h>
#include <asperity/base/folder_lock.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/parameters.h>
#include <asperity/base/version.h>
#include <asperity/tool_design/commands.h>
#include <asperity/tool_design/tool_search.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>

namespace asperity
{
  int
  optimize_tool(const std::string &file)
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    ToolDesignParameters     parameters;
    parameters.declare(declarator);
    declarator.read_file(file);
    parameters.check(declarator);
    if (MpiSession::n_ranks() > 1)
      throw InputError("'asperity optimize' was started on " +
                       std::to_string(MpiSession::n_ranks()) +
                       " ranks; its runs follow each other: one is expected.");
    ToolSearch        search(parameters);
    const std::string where = declarator.where("Output/Output directory");
    const FolderLock  lock(parameters.directory, where);
    search.claim_folder(where);
    std::cout << version_line() << "\n" << std::flush;
    search.run();
    write_tools(search, parameters);
    print_tools(search, parameters, std::cout);
    return 0;
  }



  void
  declare_design_parameters(ParameterDeclarator &parameters)
  {
    static ToolDesignParameters design;
    design.declare(parameters);
  }
} // namespace asperity
