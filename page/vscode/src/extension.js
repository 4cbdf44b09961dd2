// Starts `unoclp lsp` for the texts that it knows. Owns the start and the end of it. Must not know what a word means.

const { workspace, window, env } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

const LANGUAGES = ["st", "scl", "il", "iscl", "lce"];

/** The client that runs; none where the program could not be started. */
let client;

async function start() {
  const settings = workspace.getConfiguration("unoclp");
  const run = { command: settings.get("command"), args: ["lsp", "--board", settings.get("board")] };
  const documents = LANGUAGES.map((language) => ({ language }));
  client = new LanguageClient("unoclp", "unoclp", run, { documentSelector: documents });
  try {
    await client.start();
  } catch (error) {
    const isPortuguese = env.language.toLowerCase().startsWith("pt");
    const said = isPortuguese
      ? `O programa ${run.command} não pôde ser iniciado (${error.message}). Instale-o, ou diga onde está em unoclp.command.`
      : `The program ${run.command} could not be started (${error.message}). Install it, or say where it is in unoclp.command.`;
    void window.showErrorMessage(said);
  }
}

async function stop() {
  const before = client;
  client = undefined;
  await before?.dispose().catch(() => undefined);
}

exports.activate = async (context) => {
  context.subscriptions.push(
    workspace.onDidChangeConfiguration(async (change) => {
      if (!change.affectsConfiguration("unoclp")) return;
      await stop();
      await start();
    }),
  );
  await start();
};

exports.deactivate = stop;
