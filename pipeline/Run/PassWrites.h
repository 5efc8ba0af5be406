// Holds the textures that one pass of a run wrote, for observers while the run goes on (FRunOptions::OnPassExecuted).
#pragma once

#include "RenderGraphCompiled.h"

#include <string>
#include <vector>

class FRDGPass;
class FRHITexture;

namespace Drydock
{

/** One mip of a texture. */
struct FWrittenMip
{
	std::string Resource;
	FRHITexture* Texture = nullptr; // to be read during the call
	int Mip = 0;
	bool bExternal = false; // registered, and so full before
	FIntRect Window;        // what passes have written of it so far, pixels; all of it where that is not known
};

struct FPassWrites
{
	int PassIndex = 0; // of the compiled graph's passes
	const FRDGPass& Pass;
	const FRDGCompiledGraph& Graph; // without passes while a graph runs in immediate mode
	std::vector<FWrittenMip> Mips;
};

} // namespace Drydock
