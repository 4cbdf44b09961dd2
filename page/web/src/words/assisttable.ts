// The texts of what helps one write, in English and in Brazilian Portuguese.

export const ASSIST = {
  textMenu: ["Edit text", "Editar texto"],
  suggest: ["Suggestions", "Sugestões"],
  declaration: ["Go to declaration", "Ir para a declaração"],
  findUses: ["Find uses", "Localizar usos"],
  renameName: ["Rename", "Renomear"],
  formText: ["Format", "Formatar"],
  remedies: ["Fix this line", "Corrigir esta linha"],
  newName: ["New name", "Novo nome"],
  notDeclared: ["There is no declared name here.", "Não há um nome declarado aqui."],
  changedSince: ["The text was changed in the meantime. Try again.", "O texto mudou nesse meio-tempo. Tente de novo."],
  noRemedy: ["Nothing on this line can be fixed automatically.", "Nada nesta linha pode ser corrigido automaticamente."],
  useDeclares: ["declared here", "declarado aqui"],
  useWrites: ["written here", "escrito aqui"],
} as const satisfies Readonly<Record<string, readonly [string, string]>>;
