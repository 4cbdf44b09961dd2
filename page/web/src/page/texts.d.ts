/** A program that is bundled as it stands. */
declare module "*.il" {
  const text: string;
  export default text;
}

/** A program in Structured Text, likewise. */
declare module "*.st" {
  const text: string;
  export default text;
}
