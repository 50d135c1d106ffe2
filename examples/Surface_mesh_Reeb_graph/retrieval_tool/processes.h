#ifndef RETRIEVAL_TOOL_PROCESSES_H
#define RETRIEVAL_TOOL_PROCESSES_H

#ifdef RETRIEVAL_WITH_MPI
#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#endif

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

// The processes that share the work: those of MPI, or one.
class Processes
{
public:
  std::size_t rank() const;
  std::size_t size() const;
  bool is_first() const { return rank() == 0; }

  // The number of the process whose turn it is.
  bool has(std::size_t i) const { return i % size() == rank(); }

  // Gives everybody what the first one has.
  void broadcast(std::vector<std::string>& words) const;

  // The sum over all processes; everybody waits for it.
  std::size_t sum(std::size_t number) const;

  // Completes the rows of the first process by those that the others have, whose turn it was.
  void gather(std::vector<std::vector<double>>& rows) const;

  // Ends all processes if there are others, which would wait for this one.
  void abandon() const;

private:
#ifdef RETRIEVAL_WITH_MPI
  boost::mpi::environment m_environment;
  boost::mpi::communicator m_world;
#endif
};

#ifdef RETRIEVAL_WITH_MPI

inline std::size_t Processes::rank() const
{
  return static_cast<std::size_t>(m_world.rank());
}

inline std::size_t Processes::size() const
{
  return static_cast<std::size_t>(m_world.size());
}

inline void Processes::broadcast(std::vector<std::string>& words) const
{
  boost::mpi::broadcast(m_world, words, 0);
}

inline std::size_t Processes::sum(std::size_t number) const
{
  return boost::mpi::all_reduce(m_world, number, std::plus<std::size_t>());
}

inline void Processes::gather(std::vector<std::vector<double>>& rows) const
{
  std::vector<std::vector<std::vector<double>>> all;
  boost::mpi::gather(m_world, rows, all, 0);
  if (is_first())
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = all[i % size()][i];
}

inline void Processes::abandon() const
{
  if (size() > 1)
    m_world.abort(EXIT_FAILURE);
}

#else

inline std::size_t Processes::rank() const
{
  return 0;
}

inline std::size_t Processes::size() const
{
  return 1;
}

inline void Processes::broadcast(std::vector<std::string>&) const {}

inline std::size_t Processes::sum(std::size_t number) const
{
  return number;
}

inline void Processes::gather(std::vector<std::vector<double>>&) const {}

inline void Processes::abandon() const {}

#endif

#endif // RETRIEVAL_TOOL_PROCESSES_H
