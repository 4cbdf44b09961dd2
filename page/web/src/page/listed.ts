// The machines of the gallery: each with a program that controls it, if it is one of ours. They load once the page stands.

import type { Both, Text } from "../tools/answers";
import { fetched } from "./fetched";
import type { MachineFile } from "./machine";

export interface ListedMachine extends MachineFile {
  readonly title: Both;
  readonly about: Both;
  readonly solution?: Text;
}

export async function listedMachines(): Promise<readonly ListedMachine[]> {
  return (await fetched<ListedMachine>("machines.json")) ?? [];
}
