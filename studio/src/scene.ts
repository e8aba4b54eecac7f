// SPDX-License-Identifier: Apache-2.0
// The skin in three dimensions: layers, slider, taxels, sections of a field, the contact on the face. Lengths in mm;
// the thickness is stretched, so that layers of micrometres can be seen. Drawn only when something changes.
import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { ColourScale, apart, colour, is_dark, lines, slip, stick } from "./colours";
import { Geometry } from "./geometry";
import { Pressed } from "./stored_fields";
import { Section } from "./volume";

export class Scene {
  readonly element = document.createElement("div");
  frames = 0;
  private renderer: three.WebGLRenderer;
  private scene = new three.Scene();
  private camera = new three.PerspectiveCamera(35, 2, 0.1, 500);
  private controls: OrbitControls;
  private skin = new three.Group();
  private sections = new three.Group();
  private face = new three.Group();
  private slider = new three.Group();
  private stretch = 10;
  private pending = 0;
  private software: boolean;
  private still = 0;
  private geometry?: Geometry;

  /// Throws Error when the browser has no WebGL.
  constructor() {
    this.software = drawn_in_software();
    this.renderer = new three.WebGLRenderer({ antialias: !this.software });
    this.renderer.setPixelRatio(this.software ? 1 : Math.min(2, window.devicePixelRatio));
    this.element.className = "scene";
    this.element.append(this.renderer.domElement);
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "Skin and slider in three dimensions; arrow keys turn the view, plus and minus come closer and go back");
    canvas.addEventListener("keydown", (event) => this.turn(event));
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.render());
    const light = new three.DirectionalLight(0xffffff, 2);
    light.position.set(-5, -10, 20);
    this.scene.add(new three.AmbientLight(0xffffff, 1.6), light, this.skin, this.sections, this.face, this.slider);
    new ResizeObserver(() => this.fit()).observe(this.element);
  }

  get canvas(): HTMLCanvasElement { return this.renderer.domElement; }

  show(geometry: Geometry): void {
    this.geometry = geometry;
    this.build_skin();
    this.build_slider();
    const reach = Math.max(geometry.length, geometry.width * 1.5);
    this.controls.target.set(geometry.length / 2, geometry.width / 2, this.height() / 2);
    this.camera.position.set(geometry.length * 0.42, -reach * 1.05, reach * 0.72);
    this.controls.update();
    this.fit();
  }

  set_stretch(stretch: number): void {
    this.stretch = stretch;
    if (this.geometry) this.build_skin();
  }

  /// @param x,y,z centre and height of the slider's underside above the face [mm]
  move_slider(x: number, y: number, z: number): void {
    this.slider.position.set(x, y, this.height() + Math.max(0, z));
    this.face.position.set(x, y, this.height() + 0.012);
    this.render();
  }

  show_sections(sections: Section[], scale: ColourScale): void {
    clear(this.sections);
    const bottom = this.core_bottom();
    for (const section of sections) {
      const shape = new three.BufferGeometry();
      shape.setAttribute("position", new three.BufferAttribute(section.positions, 3));
      const colours = new Float32Array(section.values.length * 3);
      const linear = new three.Color();
      section.values.forEach((value, i) => {
        const [r, g, b] = colour(scale, value);
        linear.setRGB(r, g, b, three.SRGBColorSpace);
        colours.set([linear.r, linear.g, linear.b], i * 3);
      });
      shape.setAttribute("color", new three.BufferAttribute(colours, 3));
      shape.setIndex(new three.BufferAttribute(section.index, 1));
      this.sections.add(new three.Mesh(shape, new three.MeshBasicMaterial({ vertexColors: true, side: three.DoubleSide })));
    }
    this.sections.scale.z = this.stretch;
    this.sections.position.z = bottom * this.stretch;
    this.render();
  }

  /// The contact per face cell: its pressure, or where it sticks and slips.
  show_contact(contact: Pressed | undefined, what: string, scale: ColourScale): void {
    clear(this.face);
    if (contact) {
      const mirrored = Math.abs(contact.y[contact.y.length - 1]) < 1e-9 && contact.y[0] < -1e-6;
      for (const side of mirrored ? [1, -1] : [1]) this.face.add(cells_of(contact, what, scale, side));
    }
    this.slider.traverse((part) => {
      if (part instanceof three.Mesh) (part.material as three.Material).opacity = contact ? 0.16 : 0.55;
    });
    this.render();
  }

  render(): void {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      if (this.software) this.smooth_when_still();
      this.draw();
    });
  }

  /// Smooth edges without a graphics processor cost most of a frame: they come when nothing moves.
  private smooth_when_still(): void {
    if (this.renderer.getPixelRatio() !== 1) this.renderer.setPixelRatio(1);
    clearTimeout(this.still);
    this.still = window.setTimeout(() => {
      this.renderer.setPixelRatio(2);
      this.draw();
    }, 250);
  }

  /// Draws at once, so that the canvas can be copied.
  draw(): void {
    this.scene.background = new three.Color(is_dark() ? 0x151a20 : 0xf6f7f9);
    this.renderer.render(this.scene, this.camera);
    this.frames += 1;
  }

  private height(): number {
    return (this.geometry?.layers ?? []).reduce((sum, layer) => sum + layer.thickness, 0) * this.stretch;
  }

  private core_bottom(): number {
    const layers = this.geometry?.layers ?? [];
    const core = Math.max(0, layers.findIndex((layer) => layer.role === "core"));
    return layers.slice(0, core).reduce((sum, layer) => sum + layer.thickness, 0);
  }

  private build_skin(): void {
    clear(this.skin);
    const shape = this.geometry!;
    let z = 0;
    for (const layer of shape.layers) {
      const thickness = layer.thickness * this.stretch;
      const box = new three.BoxGeometry(shape.length, shape.width, thickness);
      const metal = layer.role !== "core";
      const mesh = new three.Mesh(box, new three.MeshLambertMaterial({ color: metal ? 0xaab2bc : 0xd9c9a3, transparent: true,
        opacity: metal ? 0.22 : 0.06, depthWrite: false }));
      const edges = new three.LineSegments(new three.EdgesGeometry(box), new three.LineBasicMaterial({ color: is_dark() ? 0x9aa5b1 : 0x55606c }));
      for (const part of [mesh, edges]) {
        part.position.set(shape.length / 2, shape.width / 2, z + thickness / 2);
        this.skin.add(part);
      }
      z += thickness;
    }
    this.skin.add(...rulers(shape.length, shape.width));
    shape.taxels.forEach((taxel, i) => this.skin.add(...taxel_parts(taxel.lower, taxel.upper, taxel.name, lines[i % lines.length], z + 0.006)));
    this.sections.scale.z = this.stretch;
    this.sections.position.z = this.core_bottom() * this.stretch;
    this.render();
  }

  private build_slider(): void {
    clear(this.slider);
    const shape = this.geometry!;
    if (!shape.slides) return;
    const material = new three.MeshLambertMaterial({ color: 0x5b7fa8, transparent: true, opacity: 0.55, depthWrite: false });
    let body: three.BufferGeometry;
    let middle = 0;
    if (shape.shape === "sphere") {
      body = new three.SphereGeometry(shape.radius, 40, 24);
      middle = shape.radius;
    } else if (shape.shape === "cylinder") {
      body = new three.CylinderGeometry(shape.radius, shape.radius, shape.size[1], 48);
      middle = shape.radius;
    } else {
      body = new three.BoxGeometry(shape.size[0], shape.size[1], 1.2);
      middle = 0.6;
    }
    const mesh = new three.Mesh(body, material);
    mesh.position.z = middle;
    this.slider.add(mesh);
    if (shape.shape !== "sphere") {
      const edges = new three.LineSegments(new three.EdgesGeometry(body, 30), new three.LineBasicMaterial({ color: 0x2c4a6e }));
      edges.position.z = middle;
      this.slider.add(edges);
    }
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    // A narrow window sees the whole length, too.
    this.camera.fov = Math.min(70, 35 * Math.max(1, 1.7 / this.camera.aspect));
    this.camera.updateProjectionMatrix();
    this.render();
  }

  private turn(event: KeyboardEvent): void {
    const turns: Record<string, [number, number, number]> = { ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, -0.08, 1],
      ArrowDown: [0, 0.08, 1], "+": [0, 0, 0.9], "-": [0, 0, 1.1] };
    const turn = turns[event.key];
    if (!turn) return;
    event.preventDefault();
    const offset = this.camera.position.clone().sub(this.controls.target);
    const place = new three.Spherical().setFromVector3(new three.Vector3(offset.x, offset.z, -offset.y));
    place.theta += turn[0];
    place.phi = Math.min(Math.PI - 0.05, Math.max(0.05, place.phi + turn[1]));
    place.radius *= turn[2];
    const moved = new three.Vector3().setFromSpherical(place);
    this.camera.position.copy(this.controls.target).add(new three.Vector3(moved.x, -moved.z, moved.y));
    this.controls.update();
    this.render();
  }
}

/// True if WebGL is computed by the processor, as in virtual machines and on servers.
function drawn_in_software(): boolean {
  const probe = document.createElement("canvas").getContext("webgl2");
  const info = probe?.getExtension("WEBGL_debug_renderer_info");
  const name = probe && info ? String(probe.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  probe?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

function clear(group: three.Group): void {
  for (const child of [...group.children]) {
    group.remove(child);
    child.traverse((part) => {
      if (part instanceof three.Mesh || part instanceof three.LineSegments) {
        part.geometry.dispose();
        (part.material as three.Material).dispose();
      }
    });
  }
}

function cells_of(contact: Pressed, what: string, scale: ColourScale, side: number): three.Mesh {
  const [ny, nx] = contact.pressure.shape;
  const positions: number[] = [], colours: number[] = [];
  const linear = new three.Color();
  for (let j = 0; j < ny; ++j) {
    for (let i = 0; i < nx; ++i) {
      const at = j * nx + i;
      const pressure = contact.pressure.values[at];
      const rgb = what === "pressure" ? colour(scale, pressure) : pressure <= 0 ? apart : contact.slip.values[at] > 0 ? slip : stick;
      linear.setRGB(...rgb, three.SRGBColorSpace);
      const [x0, x1, y0, y1] = [contact.x[i], contact.x[i + 1], side * contact.y[j], side * contact.y[j + 1]];
      positions.push(x0, y0, 0, x1, y0, 0, x1, y1, 0, x0, y0, 0, x1, y1, 0, x0, y1, 0);
      for (let k = 0; k < 6; ++k) colours.push(linear.r, linear.g, linear.b);
    }
  }
  const shape = new three.BufferGeometry();
  shape.setAttribute("position", new three.Float32BufferAttribute(positions, 3));
  shape.setAttribute("color", new three.Float32BufferAttribute(colours, 3));
  return new three.Mesh(shape, new three.MeshBasicMaterial({ vertexColors: true, side: three.DoubleSide }));
}

/// Rulers in mm beside the skin, along x and y from its corner; their ends name the axes.
function rulers(length: number, width: number): three.Object3D[] {
  const marks: three.Vector3[] = [], parts: three.Object3D[] = [];
  const along = (end: number, name: string, at: (distance: number, away: number) => three.Vector3) => {
    const rough = Math.max(end / 5, length / 12), decade = 10 ** Math.floor(Math.log10(rough));
    const step = decade * ([1, 2, 5, 10].find((one) => one * decade >= rough) ?? 10);
    marks.push(at(0, 0.3), at(end, 0.3));
    for (let k = 0; k * step <= end * 1.0001; ++k) {
      marks.push(at(k * step, 0.3), at(k * step, 0.5));
      parts.push(label(String(Number((k * step).toPrecision(3))), at(k * step, 0.9)));
    }
    parts.push(label(`${name} [mm]`, name === "x" ? at(end * 1.02 + 0.9, 0.3) : at(end / 2, 2)));
  };
  along(length, "x", (distance, away) => new three.Vector3(distance, -away, 0));
  along(width, "y", (distance, away) => new three.Vector3(-away, distance, 0));
  parts.push(new three.LineSegments(new three.BufferGeometry().setFromPoints(marks), new three.LineBasicMaterial({ color: is_dark() ? 0x9aa5b1 : 0x55606c })));
  return parts;
}

function label(text: string, place: three.Vector3): three.Sprite {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [256, 64];
  const pen = canvas.getContext("2d")!;
  pen.font = "bold 44px sans-serif";
  pen.textAlign = "center";
  pen.fillStyle = is_dark() ? "#fff" : "#111";
  pen.fillText(text, 128, 48);
  const sprite = new three.Sprite(new three.SpriteMaterial({ map: new three.CanvasTexture(canvas), depthTest: false }));
  sprite.scale.set(2.4, 0.6, 1);
  sprite.position.copy(place);
  return sprite;
}

/// A taxel's outline and its name beside it.
function taxel_parts(lower: [number, number], upper: [number, number], name: string, ink: string, z: number): three.Object3D[] {
  const corners = [[lower[0], lower[1]], [upper[0], lower[1]], [upper[0], upper[1]], [lower[0], upper[1]], [lower[0], lower[1]]];
  const inset = 0.04;
  const middle = [(lower[0] + upper[0]) / 2, (lower[1] + upper[1]) / 2];
  const points = corners.map(([x, y]) => new three.Vector3(x + Math.sign(middle[0] - x) * inset, y + Math.sign(middle[1] - y) * inset, z));
  const outline = new three.Line(new three.BufferGeometry().setFromPoints(points), new three.LineBasicMaterial({ color: ink }));
  const place = new three.Vector3(middle[0], upper[1] + 0.2, z + 0.15);
  return [outline, label(name.length > 9 ? name.slice(0, 8) + "…" : name, place)];
}
