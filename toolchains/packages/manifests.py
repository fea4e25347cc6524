# SPDX-License-Identifier: MIT
"""What registries and build systems read from the root of a repository that is named by its URL. Each is a text that follows from
the project; packages.py writes them and compares them."""

import json

AUTHORS = "the batuta authors"
CONTACT = "batuta@example.org"  # who publishes it puts his own here, and the address of his repository below
HOMEPAGE = "https://example.org/batuta"
KEYWORDS = ["collision detection", "continuous collision", "haptics", "force feedback", "rigid body", "fencing"]
ARDUINO_EIGEN = ("hideakitai", "ArduinoEigen", "0.3.2")
ESPRESSIF_EIGEN = "~3.4.0"
WRITTEN = "Written by toolchains/packages/packages.py"
PARAGRAPH = ("Decides when two moving capsules touch and what happens then: no heap, no exceptions, no unbounded loop, no contact "
             "missed. Time of contact, closest points, worlds of bodies, forces for a stick.")


def platformio(project):
    owner, name, version = ARDUINO_EIGEN
    return json.dumps({
        "$schema": "https://raw.githubusercontent.com/platformio/platformio-core/develop/platformio/assets/schema/library.json",
        "name": project.name,
        "version": project.version,
        "description": project.description,
        "keywords": KEYWORDS,
        "license": "MIT",
        "authors": [{"name": AUTHORS}],
        "headers": "batuta/world/world.hpp",
        "frameworks": "*",
        "platforms": "*",
        "dependencies": [{"owner": owner, "name": name, "version": f"^{version}"}],
        "build": {
            "srcDir": "src",
            "includeDir": "include",
            "srcFilter": ["-<*>"] + [f"+<{source[len('src/'):]}>" for source in project.sources()],
            "flags": [f"-D{word}" for word in project.core_definitions] + project.core_flags,
            "extraScript": "toolchains/packages/platformio_flags.py",
        },
        "export": {"include": ["include", "src", "examples", "toolchains/packages/platformio_flags.py", "LICENSE", "README.md"]},
    }, indent=2) + "\n"


def arduino(project):
    lines = {
        "name": project.name, "version": project.version, "author": AUTHORS, "maintainer": f"{AUTHORS} <{CONTACT}>",
        "sentence": f"{project.description}.", "paragraph": PARAGRAPH, "category": "Device Control", "url": HOMEPAGE,
        "architectures": "*", "includes": "batuta.h", "depends": ARDUINO_EIGEN[1],
    }
    return "".join(f"{key}={value}\n" for key, value in lines.items())


def esp_idf(project):
    return f"""# {WRITTEN}
version: "{project.version}"
description: "{project.description}"
license: "MIT"
dependencies:
  idf:
    version: ">=5.0"
  espressif/eigen:
    version: "{ESPRESSIF_EIGEN}"
    public: true
"""


def zephyr(project):
    return f"""# {WRITTEN}
name: {project.name}
build:
  cmake: zephyr
  kconfig: zephyr/Kconfig
"""


def cmake_lists(project):
    def block(name, words):
        return f"set({name}\n" + "".join(f"  {word}\n" for word in words) + ")\n"
    everywhere = [flag for flag in project.flags if not flag.startswith("-std=")]
    return (f"# {WRITTEN}: the library's files and flags, for build systems that bring their own CMake.\n" +
            block("BATUTA_SOURCES", project.sources()) +
            block("BATUTA_FLAGS", everywhere) +
            block("BATUTA_CORE_DEFINITIONS", project.core_definitions) +
            block("BATUTA_CORE_FLAGS", project.core_flags))


def cmsis_pack(project, files, date):
    """The description of a CMSIS-Pack: every file that a compiler reads."""
    def entry(name):
        kind = "header" if name.endswith((".hpp", ".h")) else "sourceCpp"
        return f'        <file category="{kind}" name="{name}"/>'
    listed = "\n".join(entry(name) for name in files)
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<package schemaVersion="1.7.7" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance" xs:noNamespaceSchemaLocation="PACK.xsd">
  <vendor>{project.name}</vendor>
  <name>{project.name}</name>
  <description>{project.description}. Needs Eigen 3.4 on the include path.</description>
  <url>{HOMEPAGE}/</url>
  <license>LICENSE</license>
  <releases>
    <release version="{project.version}" date="{date}">See CHANGELOG.md</release>
  </releases>
  <keywords>
    {"".join(f"<keyword>{word}</keyword>" for word in KEYWORDS)}
  </keywords>
  <conditions>
    <condition id="Cortex-M">
      <accept Dcore="Cortex-M0+"/>
      <accept Dcore="Cortex-M3"/>
      <accept Dcore="Cortex-M4"/>
      <accept Dcore="Cortex-M7"/>
      <accept Dcore="Cortex-M33"/>
      <accept Dcore="Cortex-M55"/>
    </condition>
  </conditions>
  <components>
    <component Cclass="Physics" Cgroup="Collision" Csub="{project.name}" Cversion="{project.version}" condition="Cortex-M">
      <description>{project.description}</description>
      <files>
        <file category="doc" name="README.md"/>
        <file category="include" name="include/"/>
{listed}
      </files>
    </component>
  </components>
</package>
"""


def committed(project):
    """Path from the root: the text that has to stand there."""
    return {
        "library.json": platformio(project),
        "library.properties": arduino(project),
        "idf_component.yml": esp_idf(project),
        "zephyr/module.yml": zephyr(project),
        "toolchains/packages/files.cmake": cmake_lists(project),
    }
