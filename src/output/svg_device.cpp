#include "output/svg_device.hpp"

#include <vtkAutoInit.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkViewport.h>
#include <vtkWindow.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

// Text is measured with FreeType.
VTK_MODULE_INIT(vtkRenderingFreeType)

namespace moat {

std::string hex_colour(const unsigned char* rgb) {
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  return text.data();
}

namespace {

/// A sheet of paper of given size: all the SVG device asks of a window.
class PaperWindow : public vtkWindow {
 public:
  static PaperWindow* New() { VTK_STANDARD_NEW_BODY(PaperWindow); }
  vtkTypeMacro(PaperWindow, vtkWindow)
};

class Paper : public vtkViewport {
 public:
  static Paper* New() { VTK_STANDARD_NEW_BODY(Paper); }
  vtkTypeMacro(Paper, vtkViewport)

  void resize(int width, int height) {
    window_->SetSize(width, height);
    this->VTKWindow = window_;
  }
  vtkWindow* GetVTKWindow() override { return window_; }
  vtkAssemblyPath* PickProp(double, double) override { return nullptr; }
  vtkAssemblyPath* PickProp(double, double, double, double) override { return nullptr; }
  ~Paper() override { this->VTKWindow = nullptr; }

 private:
  vtkNew<PaperWindow> window_;
};

/// VTK's SVG device writes data coordinates under an SVG transform, which distorts line widths, and its <text> elements
/// are misplaced in most viewers. This one applies transforms itself, writes pixels, and places text by standard
/// attributes only. It does not clip: nothing outside the plot area is given to it.
class PixelSvgDevice : public vtkSVGContextDevice2D {
 public:
  static PixelSvgDevice* New() { VTK_STANDARD_NEW_BODY(PixelSvgDevice); }
  vtkTypeMacro(PixelSvgDevice, vtkSVGContextDevice2D)

  void SetMatrix(vtkMatrix3x3* matrix) override { matrix_->DeepCopy(matrix); }
  void GetMatrix(vtkMatrix3x3* matrix) override { matrix->DeepCopy(matrix_); }
  void MultiplyMatrix(vtkMatrix3x3* matrix) override { vtkMatrix3x3::Multiply3x3(matrix_, matrix, matrix_); }
  void PushMatrix() override {
    std::array<double, 9> entries;
    std::copy_n(matrix_->GetData(), 9, entries.begin());
    stack_.push_back(entries);
  }
  void PopMatrix() override {
    std::copy_n(stack_.back().begin(), 9, matrix_->GetData());
    stack_.pop_back();
  }
  void EnableClipping(bool) override {}
  void SetClipping(int*) override {}

  void DrawPoly(float* points, int n, unsigned char*, int) override {
    if (this->Pen->GetLineType() == vtkPen::NO_PEN) return;
    std::vector<float> pixels = to_pixels(points, n);
    Superclass::DrawPoly(pixels.data(), n);
  }
  void DrawLines(float* points, int n, unsigned char*, int) override {
    std::vector<float> pixels = to_pixels(points, n);
    Superclass::DrawLines(pixels.data(), n);
  }
  void DrawQuad(float* points, int n) override { DrawPolygon(points, n); }
  void DrawPolygon(float* points, int n) override {
    if (this->Brush->GetOpacity() == 0) return;
    std::vector<float> pixels = to_pixels(points, n);
    Superclass::DrawPolygon(pixels.data(), n);
  }
  void DrawMarkers(int, bool, float* points, int n, unsigned char*, int) override {
    const std::vector<float> pixels = to_pixels(points, n);
    const std::string colour = hex_colour(this->Pen->GetColor());
    for (std::size_t i = 0; i + 1 < pixels.size(); i += 2) {
      vtkNew<vtkXMLDataElement> circle;
      circle->SetName("circle");
      circle->SetFloatAttribute("cx", pixels[i]);
      circle->SetFloatAttribute("cy", this->CanvasHeight - pixels[i + 1]);
      circle->SetFloatAttribute("r", 0.5f * this->Pen->GetWidth());
      circle->SetAttribute("fill", colour.c_str());
      this->ActiveNode->AddNestedElement(circle);
    }
  }
  using vtkSVGContextDevice2D::DrawString;
  void DrawString(float* point, const vtkStdString& string) override {
    const std::vector<float> pixel = to_pixels(point, 1);
    const int size = this->TextProp->GetFontSize();
    // From the point to the baseline, for the usual proportions of a sans-serif face.
    double drop = -0.21 * size;
    if (this->TextProp->GetVerticalJustification() == VTK_TEXT_CENTERED) drop = 0.36 * size;
    if (this->TextProp->GetVerticalJustification() == VTK_TEXT_TOP) drop = 0.78 * size;
    std::ostringstream transform;
    transform << "translate(" << pixel[0] << "," << this->CanvasHeight - pixel[1] << ")";
    if (this->TextProp->GetOrientation() != 0.0) transform << " rotate(" << -this->TextProp->GetOrientation() << ")";
    std::array<double, 3> colour;
    this->TextProp->GetColor(colour.data());
    std::array<unsigned char, 3> bytes;
    for (std::size_t i = 0; i < 3; ++i) bytes[i] = static_cast<unsigned char>(std::lround(255.0 * colour[i]));

    vtkNew<vtkXMLDataElement> text;
    text->SetName("text");
    text->SetAttribute("transform", transform.str().c_str());
    text->SetFloatAttribute("y", static_cast<float>(drop));
    text->SetIntAttribute("font-size", size);
    text->SetAttribute("fill", hex_colour(bytes.data()).c_str());
    if (this->TextProp->GetBold() != 0) text->SetAttribute("font-weight", "bold");
    if (this->TextProp->GetJustification() == VTK_TEXT_CENTERED) text->SetAttribute("text-anchor", "middle");
    if (this->TextProp->GetJustification() == VTK_TEXT_RIGHT) text->SetAttribute("text-anchor", "end");
    text->SetCharacterData(string.c_str(), static_cast<int>(string.size()));
    this->ActiveNode->AddNestedElement(text);
  }

 private:
  /// Data to pixels, rounded to a twentieth: finer is invisible and only makes files longer.
  std::vector<float> to_pixels(const float* points, int n) const {
    const double* m = matrix_->GetData();
    std::vector<float> pixels(2 * static_cast<std::size_t>(n));
    const auto rounded = [](double value) { return static_cast<float>(std::round(20.0 * value) / 20.0); };
    for (std::size_t i = 0; i < pixels.size(); i += 2) {
      const double x = static_cast<double>(points[i]);
      const double y = static_cast<double>(points[i + 1]);
      pixels[i] = rounded(m[0] * x + m[1] * y + m[2]);
      pixels[i + 1] = rounded(m[3] * x + m[4] * y + m[5]);
    }
    return pixels;
  }

  vtkNew<vtkMatrix3x3> matrix_;
  std::vector<std::array<double, 9>> stack_;
};

/// The drawing in `page` with an SVG header around it.
std::string document(vtkXMLDataElement* page, int width, int height) {
  const std::string w = std::to_string(width);
  const std::string h = std::to_string(height);
  std::ostringstream text;
  text << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << w << "\" height=\"" << h << "\" viewBox=\"0 0 " << w
       << " " << h << "\" font-family=\"Arial, Helvetica, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n"
       << "<rect width=\"" << w << "\" height=\"" << h << "\" fill=\"#ffffff\"/>\n";
  page->PrintXML(text, vtkIndent{});
  text << "</svg>\n";
  return text.str();
}

}  // namespace

struct SvgSheet::Parts {
  vtkNew<vtkXMLDataElement> page;
  vtkNew<vtkXMLDataElement> definitions;  // stays empty: PixelSvgDevice uses none
  vtkNew<Paper> paper;
  vtkNew<PixelSvgDevice> device;
  vtkNew<vtkContext2D> painter;
  int width = 0, height = 0;
};

SvgSheet::SvgSheet(int width, int height) : parts_{std::make_unique<Parts>()} {
  vtkXMLDataElement* page = parts_->page;
  page->SetName("g");
  // The device states a stroke or a fill for each thing it draws, never both.
  page->SetAttribute("stroke", "none");
  page->SetAttribute("fill", "none");
  page->SetAttribute("stroke-linejoin", "round");
  parts_->device->SetSVGContext(page, parts_->definitions);
  resize(width, height);
  parts_->painter->Begin(parts_->device);
}

SvgSheet::~SvgSheet() = default;

vtkContext2D* SvgSheet::painter() { return parts_->painter; }

void SvgSheet::resize(int width, int height) {
  parts_->width = width;
  parts_->height = height;
  parts_->paper->resize(width, height);
  parts_->device->Begin(parts_->paper);
}

std::string SvgSheet::finish() {
  parts_->painter->End();
  parts_->device->End();
  return document(parts_->page, parts_->width, parts_->height);
}

}  // namespace moat
