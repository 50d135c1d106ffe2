#ifndef REEB_GRAPH_TOOL_PROGRESS_H
#define REEB_GRAPH_TOOL_PROGRESS_H

#include <CGAL/Real_timer.h>

#include <cmath>
#include <iostream>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

// The time that is left when a part of the work, of 1, has taken some seconds; empty as long as
// nobody can tell.
inline std::string time_left(double seconds, double part)
{
  constexpr double first_guess = 0.5; // seconds
  if (!(part > 0) || seconds < first_guess)
    return "";
  const double left = seconds / part - seconds;
  if (!(left < 1e6))
    return "";
  const auto whole = static_cast<long>(std::ceil(left));
  const std::string time = whole < 60     ? std::to_string(whole) + " s"
                           : whole < 3600 ? std::to_string((whole + 59) / 60) + " min"
                                          : std::to_string((whole + 3599) / 3600) + " h";
  return ", " + time + " left";
}

// Shows what is being done, while it is done, to somebody who watches.
class Progress
{
public:
  ~Progress() { say(""); }

  // Begins a new work.
  void say(const std::string& text)
  {
    m_text = text;
    m_timer.reset();
    if (!m_timer.is_running())
      m_timer.start();
    m_last_time = 0;
    show(text);
  }

  // Says that a part of the work, between 0 and 1, is done.
  void say_part(double part)
  {
    constexpr double pause = 0.2; // seconds, for people who read
    const double seconds = m_timer.time();
    if (seconds < m_last_time + pause)
      return;
    m_last_time = seconds;
    show(m_text + time_left(seconds, part));
  }

private:
  static void show(const std::string& text)
  {
#if defined(__unix__) || defined(__APPLE__)
    if (isatty(STDERR_FILENO))
      std::cerr << "\r\033[K" << text << std::flush;
#endif
  }

  std::string m_text;
  CGAL::Real_timer m_timer;
  double m_last_time = 0;
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
