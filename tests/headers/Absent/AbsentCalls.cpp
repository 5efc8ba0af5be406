// Calls of what is absent, each a line below its name, and before it the words that it is refused with.
// CallsDocTest.cpp gives this file to g++ and clang.
#include "AbsentClasses.h"
#include "IImageWrapperModule.h"

void CallWhatIsAbsent(UStaticMesh& Mesh, IImageWrapperModule& Wrappers, FJsonObject& Json,
	UTextureRenderTarget2D& Target, FArchive& Archive, FString& Text, TArray<uint8>& Bytes,
	const TArray<FColor>& Colors, double& Number)
{
	// no mesh is drawn; frames come rendered
	// UStaticMesh::GetRenderData
	(void)Mesh.GetRenderData();
	// no mesh is drawn; frames come rendered
	// UStaticMesh::GetNumVertices
	(void)Mesh.GetNumVertices(0);
	// no mesh is drawn; frames come rendered
	// UStaticMesh::GetNumTriangles
	(void)Mesh.GetNumTriangles(0);
	// extract the texture, and let the run write it (docs/outputs.md)
	// IImageWrapperModule::CreateImageWrapper
	(void)Wrappers.CreateImageWrapper(EImageFormat::PNG);
	// give the picture to a UTexture2D property by the config's "objects"
	// FImageUtils::ImportFileAsTexture2D
	(void)FImageUtils::ImportFileAsTexture2D(Text);
	// extract the texture, and let the run write it (docs/outputs.md)
	// FImageUtils::ExportRenderTarget2DAsPNG
	(void)FImageUtils::ExportRenderTarget2DAsPNG(&Target, Archive);
	// extract the texture, and let the run write it (docs/outputs.md)
	// FImageUtils::CompressImageArray
	FImageUtils::CompressImageArray(1, 1, Colors, Bytes);
	// give values by the config's "objects", or read the text by FFileHelper
	// FJsonObject::TryGetNumberField
	(void)Json.TryGetNumberField(Text, Number);
	// give values by the config's "objects", or read the text by FFileHelper
	// FJsonObject::TryGetStringField
	(void)Json.TryGetStringField(Text, Text);
	// give values by the config's "objects", or read the text by FFileHelper
	// FJsonObject::GetNumberField
	(void)Json.GetNumberField(Text);
	// give values by the config's "objects", or read the text by FFileHelper
	// FJsonObject::GetStringField
	(void)Json.GetStringField(Text);
}
