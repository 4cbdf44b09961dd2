"""A client of the Language Server Protocol that others wrote (pygls), against `unoclp lsp`.

Prints a line for each thing that was as it must be; ends with an error at the first that was not.
"""

import asyncio
import sys

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.client import LanguageClient

URI = "file:///tmp/p%C3%A9/main.st"
TEXT = """\
(* ação: é um teste 𝄞 *) PROGRAM main
VAR
  start AT %IX1 : BOOL;
  lamp AT %QX1 : BOOL;
  pause : TON;
END_VAR
pause(IN := start, PT := T#2s);
lamp := pausa.Q;
END_PROGRAM
"""


def here(text, word, after=0):
    """The place after so many characters of the first such word."""
    at = text.index(word) + after
    line = text.count("\n", 0, at)
    start = text.rfind("\n", 0, at) + 1
    units = len(text[start:at].encode("utf-16-le")) // 2
    return lsp.Position(line, units)


def changed(text, edits):
    """A text with the edits of a server."""
    lines = text.split("\n")

    def offset(place):
        line = lines[place.line].encode("utf-16-le")[: place.character * 2].decode("utf-16-le")
        return sum(len(before) + 1 for before in lines[: place.line]) + len(line)

    for edit in sorted(edits, key=lambda edit: offset(edit.range.start), reverse=True):
        text = text[: offset(edit.range.start)] + edit.new_text + text[offset(edit.range.end) :]
    return text


def said(name, is_so, what=""):
    if not is_so:
        raise AssertionError(f"{name}: {what}")
    print(name)


async def main():
    client = LanguageClient("test", "1")
    told = asyncio.Queue()

    @client.feature(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def _(params: lsp.PublishDiagnosticsParams):
        told.put_nowait(params)

    await client.start_io(sys.argv[1], "lsp")
    first = await client.initialize_async(
        lsp.InitializeParams(capabilities=lsp.ClientCapabilities(), process_id=None, root_uri=None, locale="pt-br")
    )
    said("initialize", first.server_info.name == "unoclp", first)
    client.initialized(lsp.InitializedParams())

    item = lsp.TextDocumentItem(uri=URI, language_id="st", version=1, text=TEXT)
    client.text_document_did_open(lsp.DidOpenTextDocumentParams(item))
    wrong = (await told.get()).diagnostics
    said("diagnostics", len(wrong) == 1 and wrong[0].code == "ST-130", wrong)
    said("place", wrong[0].range.start == here(TEXT, "pausa.Q"), wrong[0].range)
    said("Portuguese", "não foi declarado" in wrong[0].message, wrong[0].message)

    document = lsp.TextDocumentIdentifier(URI)
    actions = await client.text_document_code_action_async(
        lsp.CodeActionParams(document, wrong[0].range, lsp.CodeActionContext(diagnostics=wrong))
    )
    said("remedy", actions[0].title == "Escrever `pause`", actions)
    text = changed(TEXT, actions[0].edit.changes[URI])
    said("mended", "lamp := pause.Q;" in text, text)

    # The same by an edit of a part, as editors send it.
    edit = actions[0].edit.changes[URI][0]
    change = lsp.TextDocumentContentChangePartial(range=edit.range, text=edit.new_text)
    client.text_document_did_change(
        lsp.DidChangeTextDocumentParams(lsp.VersionedTextDocumentIdentifier(version=2, uri=URI), [change])
    )
    news = await told.get()
    said("mended there", not news.diagnostics and news.version == 2, news)

    def at(word, after=0):
        return {"text_document": document, "position": here(text, word, after)}

    offers = await client.text_document_completion_async(lsp.CompletionParams(**at("pause.Q", 7)))
    said("members", offers[0].label == "Q", offers)
    hover = await client.text_document_hover_async(lsp.HoverParams(**at("start AT", 2)))
    said("hover", "start AT %IX1 : BOOL" in hover.contents.value, hover)
    found = await client.text_document_definition_async(lsp.DefinitionParams(**at("start, PT")))
    said("declaration", found.range.start == here(text, "start AT"), found)
    context = lsp.ReferenceContext(include_declaration=True)
    uses = await client.text_document_references_async(lsp.ReferenceParams(context=context, **at("pause.Q")))
    said("uses", len(uses) == 3, uses)
    lit = await client.text_document_document_highlight_async(lsp.DocumentHighlightParams(**at("lamp :=")))
    said("highlight", [light.kind for light in lit][-1] == lsp.DocumentHighlightKind.Write, lit)
    listed = await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(document))
    names = [child.name for child in listed[0].children]
    said("symbols", listed[0].name == "main" and names == ["start", "lamp", "pause"], listed)

    name = await client.text_document_prepare_rename_async(lsp.PrepareRenameParams(**at("lamp :=")))
    said("prepare", name.start == here(text, "lamp :="), name)
    try:
        await client.text_document_rename_async(lsp.RenameParams(new_name="IF", **at("pause.Q")))
        said("refused", False, "a keyword became a name")
    except JsonRpcException as why:
        said("refused", "IF" in str(why) and "nome" in str(why), why)
    renamed = await client.text_document_rename_async(lsp.RenameParams(new_name="luz", **at("lamp :=")))
    text = changed(text, renamed.changes[URI])
    said("renamed", "luz AT %QX1" in text and "luz := pause.Q" in text and "lamp" not in text, text)

    whole = lsp.TextDocumentContentChangeWholeDocument(text="PROGRAM p\nVAR x:INT;END_VAR\nx:=x+1 ;\nEND_PROGRAM")
    client.text_document_did_change(
        lsp.DidChangeTextDocumentParams(lsp.VersionedTextDocumentIdentifier(version=3, uri=URI), [whole])
    )
    await told.get()
    options = lsp.FormattingOptions(tab_size=2, insert_spaces=True)
    edits = await client.text_document_formatting_async(lsp.DocumentFormattingParams(document, options))
    formed = changed(whole.text, edits)
    said("formed", "x := x + 1;\n" in formed, formed)

    client.text_document_did_close(lsp.DidCloseTextDocumentParams(document))
    said("closed", not (await told.get()).diagnostics)
    await client.shutdown_async(None)
    client.exit(None)
    await asyncio.sleep(0)
    print("end")


asyncio.run(asyncio.wait_for(main(), 60))
