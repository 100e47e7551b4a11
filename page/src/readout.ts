// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the point that is shown.
import { Hover } from "./hover";
import { Model } from "./data";
import { Mesh } from "./mesh";
import { byId, coordinate, readable, row } from "./text";

function matrixText([a, b, c, d]: readonly number[]): string[] {
  return [`${readable(a)}  ${readable(c)}`, `${readable(b)}  ${readable(d)}`];
}

/** Rows of name and values. */
export function readoutRows(model: Model, mesh: Mesh, hover: Hover): [string, string, string][] {
  const p = hover.sample, [first, second] = matrixText(p.jacobian);
  return [
    ["Shape", `${coordinate(p.x, model.extent)}, ${coordinate(p.y, model.extent)}`, "x, y in the input's units"],
    ["Domain", `${coordinate(p.u, model.domainFrame.extent)}, ${coordinate(p.v, model.domainFrame.extent)}`, "u, v"],
    ["Triangle", String(p.triangle), "counted from 0, as in the file"],
    ["Barycentric", p.at.map((x) => Math.max(0, x).toFixed(3)).join("  "), "at its corners"],
    ["Jacobian", `${first}\n${second}`, "dx/du dx/dv, dy/du dy/dv"],
    ["det J", readable(p.det, 5), "how much areas grow"],
    ["Distortion", readable(p.distortion, 5), "|J|\u00b2 / det J here; 2 is a similarity"],
    ["g of the triangle", readable(mesh.distortion[p.triangle], 5), "bound of the distortion on the triangle"],
    ["d_ei at its edges", readable(mesh.deviation[p.triangle], 3), "the largest C1 deviation, relative to the extent"],
  ];
}

export class Readout {
  private readonly body = byId<HTMLTableSectionElement>("point-rows");
  private readonly hint = byId("point-hint");
  private readonly places = { shape: byId("shape-place"), domain: byId("domain-place") };

  constructor(private readonly model: Model, private readonly mesh: Mesh) {}

  show(hover: Hover | null, pinned: boolean): void {
    byId("point").dataset.pinned = String(pinned);
    this.hint.hidden = hover !== null;
    const rows = hover ? readoutRows(this.model, this.mesh, hover) : [];
    this.body.replaceChildren(...rows.map(([name, value, title]) => row(name, [value], title)));
    this.places.shape.textContent = rows.length ? rows[0][1] : "";
    this.places.domain.textContent = rows.length ? rows[1][1] : "";
  }

  /** For who hears the page. */
  say(hover: Hover | null): void {
    byId("live").textContent = hover
      ? readoutRows(this.model, this.mesh, hover).slice(0, 3).map(([name, value]) => `${name} ${value}`).join("; ")
      : "No point";
  }
}
