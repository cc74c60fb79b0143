// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture.h"

#include <algorithm>
#include <filesystem>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "core/io/file_error.h"
#include "core/io/replace_file.h"

namespace loopscope {
namespace {

// VTK's images begin with the lowest row.

void CopyRows(const std::uint8_t* from, int width, int height, std::uint8_t* to) {
  const std::size_t row = 3 * static_cast<std::size_t>(width);
  for (int y = 0; y < height; ++y) {
    std::copy_n(from + y * row, row, to + (height - 1 - y) * row);
  }
}

}  // namespace

bool operator==(const Picture& a, const Picture& b) {
  return a.width == b.width && a.height == b.height && a.rgb == b.rgb;
}

std::string EncodePng(const Picture& picture) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  CopyRows(picture.rgb.data(), picture.width, picture.height,
           static_cast<std::uint8_t*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressionLevel(4);
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* const bytes = writer->GetResult();
  const char* const begin =
      reinterpret_cast<const char*>(const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0));
  return std::string(begin, begin + bytes->GetNumberOfValues());
}

void WritePng(const Picture& picture, const std::string& path) {
  ReplaceFile(path, EncodePng(picture));
}

Picture ReadPng(const std::string& path) {
  vtkNew<vtkPNGReader> reader;
  if (!std::filesystem::is_regular_file(path) || !reader->CanReadFile(path.c_str())) {
    throw FileError(path, "expected a PNG image");
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  if (image->GetScalarType() != VTK_UNSIGNED_CHAR || image->GetNumberOfScalarComponents() != 3) {
    throw FileError(path, "expected a PNG image with 8 bit RGB pixels");
  }
  Picture picture;
  picture.width = image->GetDimensions()[0];
  picture.height = image->GetDimensions()[1];
  picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) * picture.height);
  CopyRows(static_cast<const std::uint8_t*>(image->GetScalarPointer()), picture.width,
           picture.height, picture.rgb.data());
  return picture;
}

}  // namespace loopscope
