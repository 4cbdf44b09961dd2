// The texts of the editor's own panels, by their English words, in English and in Brazilian Portuguese.

export const EDITOR = {
  Find: ["Find", "Localizar"],
  Replace: ["Replace with", "Substituir por"],
  next: ["Next", "Próxima"],
  previous: ["Previous", "Anterior"],
  all: ["Select all", "Selecionar todas"],
  "match case": ["Match case", "Diferenciar maiúsculas"],
  "by word": ["Whole words", "Palavras inteiras"],
  regexp: ["Regular expression", "Expressão regular"],
  replace: ["Replace", "Substituir"],
  "replace all": ["Replace all", "Substituir todas"],
  close: ["Close", "Fechar"],
  "current match": ["current match", "ocorrência atual"],
  "on line": ["on line", "na linha"],
  "replaced match on line $": ["match replaced on line $", "ocorrência substituída na linha $"],
  "replaced $ matches": ["matches replaced: $", "ocorrências substituídas: $"],
  "Go to line": ["Go to line", "Ir para a linha"],
  go: ["Go", "Ir"],
  Diagnostics: ["Problems", "Problemas"],
  "No diagnostics": ["No problems", "Nenhum problema"],
  Completions: ["Words", "Palavras"],
} as const satisfies Readonly<Record<string, readonly [string, string]>>;

/** The phrases of the editor in a language. */
export function phrases(language: "en" | "pt"): Record<string, string> {
  return Object.fromEntries(Object.entries(EDITOR).map(([phrase, [en, pt]]) => [phrase, language === "pt" ? pt : en]));
}
