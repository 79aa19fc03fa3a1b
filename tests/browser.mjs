// Opens a page of ours in Chromium and keeps what it loads and says.

import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

/// `modules` is a node_modules folder with playwright-core.
export async function open(file, modules, chromium) {
  const playwright = createRequire(path.resolve(modules, "x.js"))("playwright-core");
  const profile = mkdtempSync(path.join(tmpdir(), "plumbline-browser-"));
  const context = await playwright.chromium.launchPersistentContext(profile, {
    executablePath: chromium,
    headless: true,
    viewport: { width: 1400, height: 900 },
    colorScheme: "light",
    hasTouch: true,
    args: [
      "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--disable-quic",
      "--no-first-run", "--disable-background-networking", "--disable-component-update",
      "--disable-sync",
    ],
  });
  const messages = [];
  const requests = [];
  const page = await context.newPage();
  page.on("console", (message) => messages.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => messages.push(`error: ${error.message}`));
  page.on("dialog", (dialog) => messages.push(`error: dialog ${dialog.message()}`));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("html[data-ready]", { timeout: 60000 });
  return {
    context, page, requests,
    errors: () => messages.filter((message) => message.startsWith("error")),
    close: async () => {
      await context.close();
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}
