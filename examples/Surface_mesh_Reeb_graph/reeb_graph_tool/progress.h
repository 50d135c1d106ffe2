#ifndef REEB_GRAPH_TOOL_PROGRESS_H
#define REEB_GRAPH_TOOL_PROGRESS_H

#include <CGAL/Real_timer.h>

#include <iostream>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

// Shows what is being done, while it is done, to somebody who watches.
class Progress
{
public:
  ~Progress() { say(""); }

  void say(const std::string& text)
  {
#if defined(__unix__) || defined(__APPLE__)
    if (isatty(STDERR_FILENO))
      std::cerr << "\r\033[K" << text << std::flush;
#endif
  }
};

template <class Work>
void timed(double& seconds, Progress& progress, const std::string& text, const Work& work)
{
  progress.say(text);
  CGAL::Real_timer timer;
  timer.start();
  work();
  seconds = timer.time();
}

#endif // REEB_GRAPH_TOOL_PROGRESS_H
