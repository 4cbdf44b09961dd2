/** A program that is bundled as it stands. */
declare module "*.il" {
  const text: string;
  export default text;
}
