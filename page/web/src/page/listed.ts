// The machines of the menu: each with a program that controls it. They load once the page stands.

import type { Both, Text } from "../tools/answers";
import type { MachineFile } from "./machine";

export interface ListedMachine extends MachineFile {
  readonly title: Both;
  readonly about: Both;
  readonly solution: Text;
}

export async function listedMachines(): Promise<readonly ListedMachine[]> {
  const answer = await fetch("machines.json");
  return (await answer.json()) as ListedMachine[];
}
