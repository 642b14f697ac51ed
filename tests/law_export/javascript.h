#ifndef asperity_tests_law_export_javascript_h
#define asperity_tests_law_export_javascript_h

#include <string>
#include <vector>

#include "exported_law.h"

namespace asperity_test
{
  /** Debian's Chromium without a window; "" if there is none. */
  inline std::string
  browser()
  {
    for (const std::string name : {"chromium", "chromium-browser"})
      if (has_program(name))
        return name + " --headless --no-sandbox --disable-gpu "
                      "--user-data-dir=browser --allow-file-access-from-files";
    return "";
  }

  /** Programs that run JavaScript, of "node" and "browser". */
  inline std::vector<std::string>
  engines()
  {
    std::vector<std::string> result;
    if (has_program("node"))
      result.push_back("node");
    if (!browser().empty())
      result.push_back("browser");
    return result;
  }

  /**
   * Runs the files of a folder, one after the other, and writes what
   * `answers()`, a function of the last of them, returns into answers.txt.
   */
  inline void
  run_javascript(const Folder                   &folder,
                 const std::string              &engine,
                 const std::vector<std::string> &files)
  {
    if (engine == "node")
      {
        std::string all;
        for (const std::string &file : files)
          all += folder.read(file);
        folder.write("all.js", all + "\nconsole.log(answers());\n");
        folder.run("node all.js >answers.txt");
        return;
      }
    std::string page = "<!DOCTYPE html>\n<meta charset=\"utf-8\">\n<body>";
    for (const std::string &file : files)
      page += "<script src=\"" + file + "\"></script>\n";
    folder.write("page.html",
                 page + "<script>document.body.textContent = answers();"
                        "</script>\n");
    folder.run(browser() + " --dump-dom page.html | sed 's/<[^>]*>//g' | "
                           "grep . >answers.txt");
  }
} // namespace asperity_test

#endif
