// Finds the shader classes of plugins by where their names lie in memory, and asks the front end for them.
#include "Run/PluginShaders.h"

#include "CodeScope.h"
#include "DiagnosticList.h"
#include "GlobalShader.h"
#include "Overlay/OverlayShaders.h"
#include "Run/RunErrors.h"
#include "Text/Fmt.inl"
#include "TextTools.h"

#include <algorithm>
#include <dlfcn.h>
#include <filesystem>
#include <set>

namespace Drydock
{

namespace
{

/** The same of a class of drydock's own that reads an overlay's file: there may be a hundred such classes. */
constexpr int32 MaxOwnPermutations = 16;

FDiagnostic MakeNote(std::string Message, std::string Where)
{
	return {.Severity = ESeverity::Note,
		.Code = NoteShaderNotLookedAt,
		.Message = std::move(Message),
		.Where = std::move(Where)};
}

/** The one of Plugins whose code names the class; empty: none. */
std::string FindPlugin(const FShaderType& Type, const std::vector<std::string>& Plugins)
{
	Dl_info Info = {};
	const bool bFound = dladdr(Type.GetName(), &Info) != 0 && Info.dli_fname;
	return bFound && std::find(Plugins.begin(), Plugins.end(), Info.dli_fname) != Plugins.end() ? Info.dli_fname : "";
}

/** Some of many: the step goes on by one within itself, so that the dimensions that vary fastest vary too. */
std::vector<int32> Thin(const std::vector<int32>& Ids, size_t Most)
{
	std::vector<int32> Some = Ids;
	const size_t Step = Ids.size() / Most;
	for (size_t Index = 0; Index < Most && Step > 0; ++Index)
	{
		Some[Index] = Ids[Index * Step + Index % Step];
	}
	Some.resize(std::min(Ids.size(), Most));
	return Some;
}

/** Whether an overlay has the class's file, or one that this includes. */
bool ReadsOverlay(const FShaderType& Type, const std::vector<FOverlayFolder>& Overlays)
{
	const std::set<std::string> Read =
		Overlays.empty() ? std::set<std::string>() : ListIncludedShaders(Type.GetShaderFilename());
	return std::any_of(Overlays.begin(), Overlays.end(),
		[&](const FOverlayFolder& Overlay)
		{
			return std::any_of(Overlay.Shaders.begin(), Overlay.Shaders.end(),
				[&](const std::string& Shader) { return Read.contains(ToLowerCase(Shader)); });
		});
}

/** Whether the pass is one of drydock's own that need no shader: of AddClearUAVPass and its like. */
bool IsClearOrCopy(const FRDGCompiledPass& Pass)
{
	return EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::Copy) || Pass.Name.starts_with("ClearUAV(") ||
		   Pass.Name.starts_with("ClearRenderTarget(") || Pass.Name.starts_with("ClearDepthStencil(");
}

std::string Count(size_t Number, const char* One, const char* Many)
{
	return fmt::format("{} {}", Number, Number == 1 ? One : Many);
}

} // namespace

std::string FPluginShaders::Describe() const
{
	return Count(NumClasses, "shader class", "shader classes") +
		   (bOverlaid ? " of its plugins and overlays, " : " of its plugins, ") +
		   Count(Permutations.size(), "permutation", "permutations");
}

FPluginShaders FindPluginShaders(const std::vector<std::string>& Plugins, const std::vector<FOverlayFolder>& Overlays)
{
	FPluginShaders Found;
	std::set<std::string> Names;
	ForEachGlobalShader(
		[&](const FGlobalShaderType& Type)
		{
			const std::string Plugin = FindPlugin(Type, Plugins);
			if (Plugin.empty() && !ReadsOverlay(Type, Overlays))
			{
				return;
			}
			const std::string Name = std::filesystem::path(Plugin).filename().string();
			const FCodeOwner Owner = {Name, std::string("shader class ") + Type.GetName()};
			std::vector<int32> Allowed;
			for (int32 Id = 0; Id < Type.GetPermutationCount(); ++Id)
			{
				if (Plugin.empty() ? Type.ShouldCompilePermutation(Id)
								   : CallCode(Owner, [&] { return Type.ShouldCompilePermutation(Id); }))
				{
					Allowed.push_back(Id);
				}
			}
			const std::vector<int32> Looked =
				Thin(Allowed, Plugin.empty() ? MaxOwnPermutations : MaxPermutationsLookedAt);
			for (const int32 Id : Looked)
			{
				Found.Permutations.push_back(FShaderRef(Type.FindOrCreateShader(Id)));
			}
			++Found.NumClasses;
			if (Plugin.empty())
			{
				Found.bOverlaid = true;
				return;
			}
			if (Looked.size() < Allowed.size())
			{
				Found.Notes.push_back(MakeNote(fmt::format("{} of its {} permutations are not looked at: drydock looks "
														   "at no more than {} of a class, spread over all dimensions",
												   Allowed.size() - Looked.size(), Allowed.size(), Looked.size()),
					fmt::format("plugin {}, shader class {}", Name, Type.GetName())));
			}
			Names.insert(Name);
		});
	Found.Plugins.assign(Names.begin(), Names.end());
	return Found;
}

void ReflectShaders(const FPluginShaders& Shaders)
{
	std::vector<FDiagnostic> Messages;
	EExitCode ExitCode = ExitDone; // of the first that fails
	for (const FShaderRef& Shader : Shaders.Permutations)
	{
		try
		{
			GetShaderReflection(Shader);
		}
		catch (const FError& Error)
		{
			AddNewDiagnostics(Messages, Error.GetDiagnostics());
			ExitCode = ExitCode == ExitDone ? Error.GetExitCode() : ExitCode;
		}
	}
	if (ExitCode != ExitDone)
	{
		throw FError(std::move(Messages), ExitCode);
	}
}

std::vector<FDiagnostic> FindUnseenPasses(const FRDGCompiledGraph& Graph, const FPluginShaders& Shaders)
{
	std::vector<FDiagnostic> Notes;
	for (const FRDGCompiledPass& Pass : Graph.Passes)
	{
		const bool bExplained = std::any_of(Shaders.Plugins.begin(), Shaders.Plugins.end(),
			[&Pass](const std::string& Plugin) { return Pass.Owner.starts_with("plugin " + Plugin + ","); });
		if (!Pass.bCulled && !Pass.Owner.empty() && Pass.Shader.empty() && !bExplained && !IsClearOrCopy(Pass))
		{
			AddNewDiagnostics(Notes,
				{MakeNote("the pass is not looked at: its lambda chooses a shader when it runs, if any, and its plugin "
						  "has no shader classes",
					"pass " + Pass.Name + ", " + Pass.Owner)});
		}
	}
	return Notes;
}

} // namespace Drydock
