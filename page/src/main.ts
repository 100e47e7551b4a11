// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together.
import { readPalette } from "./colour";
import { parseModel } from "./data";
import { Commands, installKeyboard, kLayerKeys } from "./keyboard";
import { showLegend } from "./legend";
import { buildMesh } from "./mesh";
import { Morph } from "./morph";
import { Page } from "./page";
import { Colouring, LayerName } from "./paint";
import { PointerControl } from "./pointer";
import { Readout } from "./readout";
import { Scene } from "./scene";
import { fillTables, summaryText } from "./table";
import { byId, element } from "./text";

const kExceptionalListed = 60;
/** Magnification at which a vertex of the list is shown. */
const kVertexZoom = 8;

function installLayers(page: Page): (name: LayerName) => void {
  const boxes = new Map<LayerName, HTMLInputElement>();
  const { model, mesh } = page.scene;
  const empty: Partial<Record<LayerName, boolean>> = {
    exceptional: model.exceptional.length === 0,
    relaxed: model.relaxed.length === 0,
    features: model.features.length === 0,
    mesh: mesh.edges.length === 0,
  };
  for (const [, name] of kLayerKeys) {
    const box = byId<HTMLInputElement>(`layer-${name}`);
    box.checked = page.layers[name];
    box.addEventListener("change", () => page.setLayer(name, box.checked));
    box.closest("label")?.setAttribute("data-empty", String(empty[name] === true));
    boxes.set(name, box);
  }
  return (name) => boxes.get(name)?.click();
}

function installColours(page: Page): { next: () => void; repaint: () => void } {
  const kinds: Colouring[] = ["none", "distortion", "deviation"];
  const radios = kinds.map((kind) => byId<HTMLInputElement>(`colour-${kind}`));
  const repaint = () => showLegend(page.painter, page.layers.colour, readPalette());
  radios.forEach((radio, k) => radio.addEventListener("change", () => {
    page.setLayer("colour", kinds[k]);
    repaint();
  }));
  return { repaint, next: () => radios[(kinds.indexOf(page.layers.colour) + 1) % kinds.length].click() };
}

// As the system has it, until it is chosen: the dark colours are a style sheet of their own.
function installTheme(changed: () => void): () => void {
  const sheet = byId<HTMLStyleElement>("dark"), system = matchMedia("(prefers-color-scheme: dark)");
  const button = byId("theme"), isDark = () => matchMedia(sheet.media).matches;
  const update = () => {
    button.setAttribute("aria-label", isDark() ? "Light colours" : "Dark colours");
    changed();
  };
  const toggle = () => {
    sheet.media = isDark() ? "not all" : "all";
    update();
  };
  system.addEventListener("change", update);
  button.addEventListener("click", toggle);
  update();
  return toggle;
}

function installLinked(page: Page): () => void {
  const box = byId<HTMLInputElement>("linked");
  box.checked = page.linked;
  box.addEventListener("change", () => {
    page.linked = box.checked;
    if (page.linked) page.moved(page.active);
  });
  return () => box.click();
}

function installButtons(page: Page): void {
  byId("fit").addEventListener("click", () => page.fit());
  for (const [id, factor] of [["zoom-in", 1.5], ["zoom-out", 1 / 1.5]] as const)
    byId(id).addEventListener("click", () => {
      const { camera } = page.panes[page.active];
      camera.zoomAt(factor, camera.width / 2, camera.height / 2);
      page.moved(page.active);
    });
  for (const pane of page.all) pane.top.addEventListener("focus", () => (page.active = pane.side));
}

function listExceptional(page: Page): void {
  const { model } = page.scene, list = byId("exceptional-list");
  byId("exceptional-section").hidden = model.exceptional.length === 0;
  for (const vertex of Array.from(model.exceptional).slice(0, kExceptionalListed)) {
    const button = element("button", String(vertex), { type: "button", "aria-label": `Show vertex ${vertex}` });
    button.addEventListener("click", () => {
      const [triangle, at] = page.scene.cornerAt(vertex);
      page.goTo({ triangle, at }, kVertexZoom);
    });
    list.append(button);
  }
  if (model.exceptional.length > kExceptionalListed)
    list.append(element("span", `and ${model.exceptional.length - kExceptionalListed} more`));
}

function start(): void {
  const model = parseModel(byId("result").textContent ?? ""), mesh = buildMesh(model);
  const page = new Page(new Scene(model, mesh), { shape: byId("shape-stack"), domain: byId("domain-stack") });
  const readout = new Readout(model, mesh), help = byId<HTMLDialogElement>("help");
  const colours = installColours(page);
  const morph = new Morph(page, byId<HTMLInputElement>("morph"), byId<HTMLButtonElement>("play"));
  byId("name").textContent = model.name || "Result";
  byId("summary").textContent = summaryText(model);
  fillTables(model, mesh);
  listExceptional(page);
  page.onHover = (hover) => readout.show(hover, page.pinned);
  page.onChange = () => {
    for (const pane of page.all) {
      pane.stack.dataset.zoomed = String(pane.camera.zoom > 1.001);
      byId(`${pane.side}-zoom`).textContent = `${pane.camera.zoom < 10 ? pane.camera.zoom.toFixed(1) : Math.round(pane.camera.zoom)}\u00d7`;
    }
  };
  const commands: Commands = {
    toggleLayer: installLayers(page),
    nextColour: colours.next,
    toggleLinked: installLinked(page),
    toggleTheme: installTheme(() => {
      page.repaletted();
      colours.repaint();
    }),
    toggleMorph: () => morph.toggle(),
    help: () => help.showModal(),
    say: () => readout.say(page.hover),
  };
  byId("help-open").addEventListener("click", commands.help);
  installButtons(page);
  installKeyboard(page, commands);
  for (const pane of page.all) new PointerControl(page, pane);
  new ResizeObserver(() => page.resized()).observe(byId("views"));
  window.addEventListener("resize", () => page.resized());
  readout.show(null, false);
  page.resized();
  // For scripts that drive the page.
  Object.assign(window, { c1mesh: page });
}

start();
