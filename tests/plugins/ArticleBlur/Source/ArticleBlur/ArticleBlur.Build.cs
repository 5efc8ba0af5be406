// The module of the article's view extension.
using UnrealBuildTool;

public class ArticleBlur : ModuleRules
{
	public ArticleBlur(ReadOnlyTargetRules Target) : base(Target)
	{
		PCHUsage = PCHUsageMode.UseExplicitOrSharedPCHs;
		PublicDependencyModuleNames.AddRange(new string[] { "Core", "CoreUObject", "Engine", "RenderCore", "Renderer", "RHI", "Projects" });
	}
}
