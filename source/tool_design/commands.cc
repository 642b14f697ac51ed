#include <asperity/base/errors.h>
#include <asperity/base/folder_lock.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/parameters.h>
#include <asperity/base/version.h>
#include <asperity/tool_design/commands.h>
#include <asperity/tool_design/law_search.h>
#include <asperity/tool_design/tool_search.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>

namespace asperity
{
  namespace
  {
    /** @param where the entry of the output directory */
    void
    search_tool(const ToolDesignParameters &parameters,
                const std::string          &where)
    {
      ToolSearch       search(parameters);
      const FolderLock lock(parameters.directory, where);
      search.claim_folder(where);
      std::cout << version_line() << "\n" << std::flush;
      search.run();
      write_tools(search, parameters);
      print_tools(search, parameters, std::cout);
    }

    void
    search_law(const ToolDesignParameters &parameters, const std::string &where)
    {
      const LawSearch  search(parameters);
      const FolderLock lock(parameters.directory, where);
      std::cout << version_line() << "\n" << std::flush;
      search.print(search.run(), std::cout);
    }
  } // namespace



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
    const std::string where = declarator.where("Output/Output directory");
    if (parameters.friction_law.empty())
      search_tool(parameters, where);
    else
      search_law(parameters, where);
    return 0;
  }



  void
  declare_design_parameters(ParameterDeclarator &parameters)
  {
    static ToolDesignParameters design;
    design.declare(parameters);
  }
} // namespace asperity
