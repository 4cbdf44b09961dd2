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
  noRemedy: ["There is nothing on this line that I can fix.", "Não há nada nesta linha que eu saiba corrigir."],
  useDeclares: ["declared here", "declarado aqui"],
  useWrites: ["written here", "escrito aqui"],
} as const satisfies Readonly<Record<string, readonly [string, string]>>;
