// The languages of programs, as the Rust of unoclp has them. Made like `asks.ts`: do not edit it.

/** Each language by its name: the end of the names of its files, and what it is called. */
export const LANGUAGES = {
  st: { end: ".st", en: "Structured Text", pt: "Texto Estruturado" },
  scl: { end: ".scl", en: "SCL", pt: "SCL" },
  iscl: { end: ".iscl", en: "InterSCL", pt: "InterSCL" },
  lce: { end: ".lce", en: "LCE", pt: "LCE" },
  il: { end: ".il", en: "Instruction List", pt: "Lista de Instruções" },
  xml: { end: ".xml", en: "PLCopen XML", pt: "PLCopen XML" },
  numeric: { end: ".txt", en: "Numeric code", pt: "Código numérico" },
} as const;

export type LanguageName = keyof typeof LANGUAGES;
