// The whole tutorial, in both languages, by mouse and by the keyboard alone: each step passes its own check, and its
// solution the exercise.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { keyboard, mouse } from "./hands.mjs";
import { Lab, pick } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

const WORDS = {
  "en-US": { step: "Step", open: "Open this program", check: "Check the step", exercise: "Check the exercise", solution: "Show a solution", next: "Next step", passed: "Passed", heading: "Rung 1" },
  "pt-BR": { step: "Passo", open: "Abrir este programa", check: "Verificar o passo", exercise: "Verificar o exercício", solution: "Mostrar uma solução", next: "Próximo passo", passed: "Passou", heading: "Degrau 1" },
};

for (const locale of /** @type {const} */ (["en-US", "pt-BR"])) {
  for (const hand of [mouse, keyboard]) {
    test(`each step of the tutorial passes, ${locale}, by ${hand.name}`, async () => {
      const page = await lab.still({ locale, ...hand.options });
      const words = WORDS[locale];
      const lesson = page.locator("#lesson");
      const press = (/** @type {string} */ name) => hand.press(page, lesson.getByRole("button", { name, exact: true }));
      const verdict = (/** @type {string} */ kind) => lesson.locator(`#verdict.${kind}`).waitFor();
      await pick(page, "#lessons", hand);
      let step = 1;
      for (; ; step++) {
        await lesson.locator(".chip", { hasText: `${words.step} ${step} ` }).waitFor();
        await press(words.open);
        await press(words.check);
        await verdict("good");
        assert.match((await lesson.locator("#verdict").textContent()) ?? "", new RegExp(words.passed));
        await press(words.exercise);
        await verdict("bad");
        await press(words.solution);
        await press(words.exercise);
        await verdict("good");
        if ((await lesson.getByRole("button", { name: words.next }).count()) === 0) break;
        await press(words.next);
      }
      assert.ok(step >= 10, `${step} steps`);
      // A screen reader has heard it, and the ladder is that of the last solution; one of bytes is shown where it is asked for.
      await page.locator("#live", { hasText: words.passed }).waitFor({ state: "attached" });
      await page.locator(".ladder .heading", { hasText: words.heading }).first().waitFor({ state: "attached" });
      await page.context().close();
    });
  }
}
