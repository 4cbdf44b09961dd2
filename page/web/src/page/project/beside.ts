// What stands in the place of the drawing: a chart with its ladder beside it, or a project with its units.

import { dressIn } from "../../offline/beside";
import type { Looked } from "../document";
import { type Around, ChartPane } from "../sfc/pane";
import { Past } from "./past";
import { ProjectPane } from "./pane";

export class Beside {
  private readonly chart: ChartPane;
  private readonly project: ProjectPane;
  private readonly past: Past;

  /** Loads what both need besides their code. */
  static async open(root: HTMLElement, around: Around): Promise<Beside> {
    await Promise.all([dressIn("chart.css"), dressIn("project.css")]);
    return new Beside(root, around);
  }

  private constructor(
    private readonly root: HTMLElement,
    around: Around,
  ) {
    this.past = new Past(around.program);
    this.chart = new ChartPane(around, this.past);
    this.project = new ProjectPane(root, around, this.past, this.chart);
  }

  /** Shows what a text has of these; all else is shown elsewhere. */
  async show(looked: Looked): Promise<void> {
    if (looked.checked.language === "xml") {
      this.chart.leave(this.root);
      return this.project.show(looked);
    }
    await this.project.show(null);
    this.chart.at(this.root);
    return this.chart.show(looked);
  }
}
