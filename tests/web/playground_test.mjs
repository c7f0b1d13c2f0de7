// SPDX-License-Identifier: MIT
// The playground in Chromium. Its tests share a browser and a page, which goes from state to state by its address:
// most of a page's time is its start and its sky.
import { after } from "node:test";
import { closeShared } from "./browser.mjs";
import "./access.mjs";
import "./controls.mjs";
import "./files.mjs";
import "./pictures.mjs";

after(closeShared);
