/* SPDX-License-Identifier: Apache-2.0 */

/* A picture of the scene with the finger on the middle of the skin, drawn without a screen, in PPM:

     cc picture.c -lmujoco -lEGL -o picture && ./picture finger.xml > scene.ppm */

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <mujoco/mujoco.h>

#include <stdio.h>
#include <stdlib.h>

/* A context of Mesa that needs neither a screen nor a graphics card. */
static int open_context(void) {
  const PFNEGLGETPLATFORMDISPLAYEXTPROC display_of =
      (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  if (display_of == NULL) {
    return 0;
  }
  const EGLDisplay display = display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24,
                           EGL_NONE};
  EGLConfig found;
  EGLint count = 0;
  if (!eglInitialize(display, NULL, NULL) || !eglChooseConfig(display, wanted, &found, 1, &count) || count == 0 ||
      !eglBindAPI(EGL_OPENGL_API)) {
    return 0;
  }
  const EGLContext context = eglCreateContext(display, found, EGL_NO_CONTEXT, NULL);
  return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

int main(int argc, char** argv) {
  char message[1000] = "usage: picture finger.xml > scene.ppm";
  mjModel* model = argc == 2 ? mj_loadXML(argv[1], NULL, message, sizeof message) : NULL;
  if (model == NULL) {
    fprintf(stderr, "%s\n", message);
    return 2;
  }
  if (!open_context()) {
    fprintf(stderr, "EGL draws nothing without a screen here\n");
    return 3;
  }
  mjData* data = mj_makeData(model);
  data->qpos[0] = 7.5e-3;
  data->qpos[1] = 1e-3;
  mj_forward(model, data);

  mjvScene scene;
  mjrContext context;
  mjvCamera camera;
  mjvOption option;
  mjv_defaultScene(&scene);
  mjr_defaultContext(&context);
  mjv_defaultOption(&option);
  mjv_defaultFreeCamera(model, &camera);
  mjv_makeScene(model, &scene, 100);
  mjr_makeContext(model, &context, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  const mjrRect view = mjr_maxViewport(&context);
  mjv_updateScene(model, data, &option, NULL, &camera, mjCAT_ALL, &scene);
  mjr_render(view, &scene, &context);

  const size_t row = 3 * (size_t)view.width;
  unsigned char* pixels = malloc(row * (size_t)view.height);
  if (pixels == NULL) {
    return 1;
  }
  mjr_readPixels(pixels, NULL, view, &context);
  printf("P6\n%d %d\n255\n", view.width, view.height);
  for (int i = view.height - 1; i >= 0; --i) { /* from the top */
    fwrite(pixels + row * (size_t)i, 1, row, stdout);
  }
  free(pixels);
  mjr_freeContext(&context);
  mjv_freeScene(&scene);
  mj_deleteData(data);
  mj_deleteModel(model);
  return fflush(stdout) == 0 ? 0 : 1;
}
