// From the disk no browser loads modules: the file beside this one holds the whole page.
if (location.protocol === "file:") location.replace(`unoclp.html${location.hash}`);
else document.head.append(Object.assign(document.createElement("script"), { type: "module", src: "page.js" }));
