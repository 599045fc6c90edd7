#include "render/scene/vtk_stage.hpp"

#include <GL/glew.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>

#include <stdexcept>

namespace stemwise::render {
namespace {

/// The one prop through which all layers are drawn inside VTK's opaque pass.
class LayersProp : public vtkProp {
 public:
  static LayersProp* New();
  vtkTypeMacro(LayersProp, vtkProp);

  std::vector<Layer*> layers;
  FrameView view;

  int RenderOpaqueGeometry(vtkViewport* viewport) override {
    auto* renderer = vtkRenderer::SafeDownCast(viewport);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    const vtkMatrix4x4* matrix =
        renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) view.clip_from_world(row, column) = static_cast<float>(matrix->GetElement(row, column));
    vtkOpenGLState* state = window->GetState();
    window->GetShaderCache()->ReleaseCurrentShader();
    state->Push();
    for (Layer* layer : layers) layer->draw(view);
    glUseProgram(0);
    state->Reset();  // what the layers changed behind its back
    state->Pop();
    return 1;
  }

 protected:
  LayersProp() = default;
  double* GetBounds() override { return nullptr; }
};
vtkStandardNewMacro(LayersProp);

void answer_yes(vtkObject*, unsigned long, void*, void* data) { *static_cast<bool*>(data) = true; }
void answer_supported(vtkObject*, unsigned long, void*, void* data) { *static_cast<int*>(data) = 1; }

void set_colour(double (&target)[3], Rgba colour) {
  target[0] = colour.r / 255.0;
  target[1] = colour.g / 255.0;
  target[2] = colour.b / 255.0;
}

}  // namespace

struct VtkStage::Impl {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<LayersProp> layers;
  std::vector<vtkSmartPointer<vtkActor>> surfaces;
};

VtkStage::VtkStage() : impl_(std::make_unique<Impl>()) {
  auto& window = *impl_->window;
  window.SetOwnContext(0);
  window.SetMapped(1);
  window.SetIsCurrent(true);
  window.SetSupportsOpenGL(1);
  window.SetIsDirect(1);
  window.SetFrameBlitModeToNoBlit();
  window.SwapBuffersOn();  // off would leave the display framebuffer empty; a generic window never swaps anyway
  window.SetMultiSamples(0);
  vtkNew<vtkCallbackCommand> is_current;
  is_current->SetCallback(answer_yes);
  window.AddObserver(vtkCommand::WindowIsCurrentEvent, is_current);
  vtkNew<vtkCallbackCommand> is_supported;
  is_supported->SetCallback(answer_supported);
  window.AddObserver(vtkCommand::WindowSupportsOpenGLEvent, is_supported);
  window.AddRenderer(impl_->renderer);
  impl_->renderer->SetBackgroundAlpha(1.0);
  impl_->renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(-0.5, -0.35, 0.8);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetPositional(false);
  impl_->renderer->AddLight(sun);
  impl_->renderer->AddViewProp(impl_->layers);
}

VtkStage::~VtkStage() {
  impl_->layers->layers.clear();
  impl_->window->Finalize();
}

void VtkStage::look_down(const MapCamera& camera, PixelSize size) {
  vtkCamera* c = impl_->renderer->GetActiveCamera();
  c->ParallelProjectionOn();
  c->SetFocalPoint(camera.centre_m.x(), camera.centre_m.y(), 0.0);
  c->SetPosition(camera.centre_m.x(), camera.centre_m.y(), 100.0);
  c->SetViewUp(0.0, 1.0, 0.0);
  c->SetParallelScale(0.5 * size.height * camera.metres_per_px);
  c->SetClippingRange(1.0, 200.0);
}

void VtkStage::look(const OrbitCamera& camera, PixelSize, double scene_radius_m) {
  vtkCamera* c = impl_->renderer->GetActiveCamera();
  const Eigen::Vector3d eye = camera.eye_m(), up = camera.up();
  c->ParallelProjectionOff();
  c->SetViewAngle(camera.field_of_view_rad * 180.0 / 3.14159265358979323846);
  c->SetFocalPoint(camera.target_m.x(), camera.target_m.y(), camera.target_m.z());
  c->SetPosition(eye.x(), eye.y(), eye.z());
  c->SetViewUp(up.x(), up.y(), up.z());
  const double farthest_m = eye.norm() + 2.0 * scene_radius_m + 100.0;
  c->SetClippingRange(std::max(0.05, farthest_m * 2e-4), farthest_m);
}

void VtkStage::clear_surfaces() {
  for (const auto& actor : impl_->surfaces) impl_->renderer->RemoveViewProp(actor);
  impl_->surfaces.clear();
}

void VtkStage::add_surface(vtkPolyData* surface, Rgba colour, bool is_lit) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  const bool has_colours = surface->GetPointData()->GetScalars() != nullptr;
  mapper->SetScalarVisibility(has_colours);
  if (has_colours) mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  double components[3];
  set_colour(components, colour);
  actor->GetProperty()->SetColor(components);
  actor->GetProperty()->SetLighting(is_lit);
  actor->GetProperty()->SetAmbient(is_lit ? 0.55 : 1.0);
  actor->GetProperty()->SetDiffuse(is_lit ? 0.5 : 0.0);
  actor->GetProperty()->SetSpecular(0.0);
  impl_->renderer->RemoveViewProp(impl_->layers);  // the layers stay last
  impl_->renderer->AddViewProp(actor);
  impl_->renderer->AddViewProp(impl_->layers);
  impl_->surfaces.push_back(actor.Get());
}

void VtkStage::set_layers(std::vector<Layer*> layers) { impl_->layers->layers = std::move(layers); }

unsigned int VtkStage::render(PixelSize size, FrameView view, Rgba background) {
  auto& window = *impl_->window;
  double components[3];
  set_colour(components, background);
  impl_->renderer->SetBackground(components);
  view.size = size;
  impl_->layers->view = view;
  window.SetSize(size.width, size.height);
  window.SetReadyForRendering(true);
  window.Render();
  vtkOpenGLFramebufferObject* target = window.GetDisplayFramebuffer();
  vtkTextureObject* texture = target ? target->GetColorAttachmentAsTextureObject(0) : nullptr;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!texture) throw std::runtime_error("the 3D window could not be drawn: OpenGL 3.2 is needed");
  return texture->GetHandle();
}

std::string VtkStage::renderer_name() const {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name ? name : "";
}

}  // namespace stemwise::render
