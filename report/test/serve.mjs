// The one browser of all test files: starts it and prints the address at which they reach it, until it is ended.
import { chromium } from "playwright-core";

const server = await chromium.launchServer({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox"] });
console.log(server.wsEndpoint());
process.on("SIGTERM", () => server.close().then(() => process.exit(0)));
