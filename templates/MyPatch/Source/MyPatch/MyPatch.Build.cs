using System.IO;
using UnrealBuildTool;

public class MyPatch : ModuleRules
{
	public MyPatch(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
		PrivateDependencyModuleNames.AddRange(new string[]
		{
			"Core", "CoreUObject", "Engine", "Projects", "RHI", "RenderCore", "Renderer"
		});

		// Engine versions differ in which headers of the renderer are public.
		string Renderer = Path.Combine(EngineDirectory, "Source", "Runtime", "Renderer");
		PrivateIncludePaths.Add(Path.Combine(Renderer, "Private"));
		PrivateIncludePaths.Add(Path.Combine(Renderer, "Internal"));
	}
}
