#include "readers.h"
#include "text.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace {

// Keeps the first error that VTK would print, and prints nothing: VTK's readers go on with what they
// have.
class First_error : public vtkOutputWindow
{
public:
  static First_error* New();

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (m_text.empty() && text != nullptr)
      m_text = text;
  }

  // Without the first line, which has the place in VTK's source code, and the rest in one line.
  std::string message() const
  {
    std::string message;
    Lines lines(m_text);
    std::string_view line;
    while (lines.next(line))
      if (!line.empty() && !begins_with(line, "ERROR: In "))
        (message += message.empty() ? "" : " ") += line;
    const std::size_t end_of_address = message.find("): ");
    return message.substr(end_of_address == message.npos ? 0 : end_of_address + 3);
  }

  bool is_set() const { return !m_text.empty(); }

private:
  std::string m_text;
};

vtkStandardNewMacro(First_error);

vtkSmartPointer<vtkPolyData> read_polydata(std::string_view bytes)
{
  const vtkSmartPointer<vtkOutputWindow> window = vtkOutputWindow::GetInstance();
  const vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkNew<First_error> error;
  vtkOutputWindow::SetInstance(error);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(std::string(bytes));
  reader->Update();
  vtkLogger::SetStderrVerbosity(verbosity);
  vtkOutputWindow::SetInstance(window);
  if (error->is_set() || reader->GetErrorCode() != 0)
    throw Content_error(
        "cannot be read by VTK: " +
        (error->is_set() ? error->message() : "error " + std::to_string(reader->GetErrorCode())));
  vtkPolyData* const data = reader->GetOutput();
  if (data == nullptr || data->GetNumberOfPoints() < 0)
    throw Content_error("holds no polydata");
  return data;
}

void read_points(vtkPolyData& data, Polygon_soup& soup)
{
  const vtkIdType number = data.GetNumberOfPoints();
  soup.points.reserve(static_cast<std::size_t>(number));
  for (vtkIdType i = 0; i < number; ++i) {
    std::array<double, 3> point;
    data.GetPoint(i, point.data());
    for (const double coordinate : point)
      if (!std::isfinite(coordinate))
        throw Content_error("point " + std::to_string(i) + " has a coordinate that is not finite");
    soup.points.push_back(point);
  }
}

void read_property(vtkPolyData& data, const std::string& property, Polygon_soup& soup)
{
  vtkPointData& arrays = *data.GetPointData();
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
    vtkDataArray* const array = arrays.GetArray(i);
    if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfComponents() != 1 ||
        array->GetNumberOfTuples() != data.GetNumberOfPoints())
      continue;
    soup.property_names.push_back(array->GetName());
    if (property.empty() || property != array->GetName() || soup.has_property)
      continue;
    soup.has_property = true;
    for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
      soup.property.push_back(array->GetComponent(k, 0));
  }
}

std::size_t checked(vtkIdType vertex, const Element& cell, const Polygon_soup& soup)
{
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= soup.points.size())
    throw Content_error(no_such_vertex(cell, std::to_string(vertex), soup.points.size()));
  return static_cast<std::size_t>(vertex);
}

// Calls `visit` with the points of each cell, their number, and the name of the cell.
template <class Visit>
void for_each_cell(vtkCellArray* cells, const char* kind, const Visit& visit)
{
  if (cells == nullptr || cells->GetNumberOfCells() == 0)
    return;
  if (!cells->IsValid())
    throw Content_error(std::string("the ") + kind + " cells are damaged");
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    iterator->GetCurrentCell(size, points);
    const Element cell = {kind, static_cast<std::size_t>(iterator->GetCurrentCellId())};
    if (size < 3)
      throw Content_error(cell.name() + " has " + std::to_string(size) +
                          " corners; a face has 3 at least");
    visit(points, size, cell);
  }
}

void read_cells(vtkPolyData& data, Polygon_soup& soup)
{
  for_each_cell(data.GetPolys(),
                "polygon",
                [&](const vtkIdType* points, vtkIdType size, const Element& cell) {
                  for (vtkIdType k = 0; k < size; ++k)
                    soup.corners.push_back(checked(points[k], cell, soup));
                  soup.end_polygon();
                });
  // each triangle of a strip is turned against the one before
  for_each_cell(
      data.GetStrips(), "strip", [&](const vtkIdType* points, vtkIdType size, const Element& cell) {
        for (vtkIdType k = 2; k < size; ++k) {
          const vtkIdType turn = k % 2;
          for (const vtkIdType corner : {k - 2 + turn, k - 1 - turn, k})
            soup.corners.push_back(checked(points[corner], cell, soup));
          soup.end_polygon();
        }
      });
}

} // namespace

void read_VTP(std::string_view bytes, const std::string& property, Polygon_soup& soup)
{
  const vtkSmartPointer<vtkPolyData> data = read_polydata(bytes);
  read_points(*data, soup);
  read_property(*data, property, soup);
  read_cells(*data, soup);
}
