// Follows the includes of shader files.
#include "Overlay/OverlayShaders.h"

#include "GlobalShader.h"
#include "ShaderCore.h"
#include "ShaderDirectories.h"
#include "ShaderPreprocessor.h"
#include "ShaderSource.h"
#include "Text/TextFile.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

void AddIncluded(const std::string& VirtualPath, std::set<std::string>& Found)
{
	if (!Found.insert(ToLowerCase(VirtualPath)).second)
	{
		return;
	}
	for (const std::string& Line : SplitText(TryReadTextFile(FindShaderFile(VirtualPath)).value_or("")))
	{
		if (const std::string Target = FindQuotedInclude(Line); !Target.empty())
		{
			const std::string Path = ResolveVirtualPath(Target, VirtualPath);
			const bool bFound = Target.starts_with('/') || !FindShaderFile(Path).empty();
			AddIncluded(bFound ? Path : "/Engine/Private/" + Target, Found); // as the engine looks for it
		}
	}
}

/** Every text of the value that is a path of a shader. */
void AddNamed(const FJsonValue& Value, std::set<std::string>& Found)
{
	if (Value.Type == EJsonType::String && Value.String.starts_with('/'))
	{
		AddIncluded(Value.String, Found);
	}
	for (const FJsonValue& Element : Value.Elements)
	{
		AddNamed(Element, Found);
	}
	for (const FJsonMember& Member : Value.Members)
	{
		AddNamed(Member.Value, Found);
	}
}

} // namespace

std::set<std::string> ListIncludedShaders(const std::string& VirtualPath)
{
	MapShippedShaders();
	std::set<std::string> Found;
	AddIncluded(VirtualPath, Found);
	return Found;
}

std::set<std::string> ListReadShaders(const FConfig& Config)
{
	MapShippedShaders();
	std::set<std::string> Found;
	ForEachGlobalShader([&](const FGlobalShaderType& Type) { AddIncluded(Type.GetShaderFilename(), Found); });
	for (const FJsonValue& Pass : Config.Passes)
	{
		AddNamed(Pass, Found);
	}
	return Found;
}

} // namespace Drydock
