// Tutorial and exercises, one of them at a time.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import type { ProgramDocument } from "./document";
import { byId } from "./dom";
import { Exercises } from "./exercises";
import { Lessons } from "./lessons";
import type { MachineArea } from "./machine";

export class Learning {
  private readonly lessons: Lessons;
  readonly exercises: Exercises;

  constructor(
    tools: RemoteTools,
    program: ProgramDocument,
    open: (text: Text) => void,
    /** Makes the buttons of these inputs normally closed, and no others. */
    private readonly closed: (inputs: readonly number[]) => void,
    machine: MachineArea,
  ) {
    this.lessons = new Lessons(byId("lesson"), tools, program, open);
    this.exercises = new Exercises(byId("exercise"), tools, program, open, closed, machine);
  }

  /** Opens a file of a teacher as an exercise; its machine may be among these. */
  async take(file: Text, machines: readonly Text[]): Promise<void> {
    if (await this.exercises.take(file, machines)) this.lessons.close();
  }

  /** Opens the exercise of this name. */
  async choose(name: string): Promise<void> {
    this.lessons.close();
    await this.exercises.choose(name);
  }

  /** Opens one of them in the place of the other. */
  async start(what: "lessons" | "exercises"): Promise<void> {
    this[what === "lessons" ? "exercises" : "lessons"].close();
    if (what === "lessons") this.closed([]);
    await this[what].start();
  }
}
