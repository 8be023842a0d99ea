// SPDX-License-Identifier: LGPL-3.0-or-later
#include <stdlib.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "bench/stopwatch.h"
#include "bench/surface_peers.h"

namespace veritope::bench {

namespace {

TriangleMesh mesh_of_vtk(vtkPolyData& surface) {
  TriangleMesh out;
  for (vtkIdType v = 0; v < surface.GetNumberOfPoints(); ++v) {
    const double* const p = surface.GetPoint(v);
    out.positions.push_back({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0});
  }
  const auto id = [](vtkIdType n) { return static_cast<std::uint32_t>(n); };
  vtkNew<vtkIdList> corners;
  vtkCellArray* const cells = surface.GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners);)
    out.faces.push_back({id(corners->GetId(0)), id(corners->GetId(1)), id(corners->GetId(2))});
  return out;
}

}  // namespace

PeerSurface flying_edges(FieldGrid& grid) {
  // In the place of vtkSMPTools::SetBackend: that header is no C++20.
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
  PeerSurface out;
  const Stopwatch watch;
  vtkNew<vtkFloatArray> values;
  values->SetArray(grid.values.data(), static_cast<vtkIdType>(grid.values.size()),
                   1);  // kept by grid
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size[0], grid.size[1], grid.size[2]);
  image->SetOrigin(grid.origin.x, grid.origin.y, grid.origin.z);
  image->SetSpacing(grid.step, grid.step, grid.step);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->ComputeNormalsOff();
  filter->ComputeGradientsOff();
  filter->ComputeScalarsOff();
  filter->SetValue(0, 0);
  filter->Update();
  out.ns = watch.ns();
  out.mesh = mesh_of_vtk(*filter->GetOutput());
  return out;
}

}  // namespace veritope::bench
