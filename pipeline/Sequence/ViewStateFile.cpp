// Writes the states of views as bytes and reads them back.
#include "Sequence/ViewStateFile.h"

#include "Diagnostics.h"
#include "PixelFormatConversion.h"
#include "RenderTargetPool.h"
#include "Sequence/SequenceErrors.h"
#include "Text/Fingerprint.h"

#include <cstring>
#include <limits>
#include <set>
#include <type_traits>

namespace Drydock
{

namespace
{

constexpr char Magic[] = "drydock view state 2\n";

/** Names of pooled resources are not copied by them. */
const TCHAR* Intern(const std::string& Name)
{
	static std::set<std::string> Names;
	return Names.insert(Name).first->c_str();
}

class FWriter
{
public:
	template<typename T>
	void Add(const T& Value)
	{
		static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
		AddBytes(&Value, sizeof(T));
	}
	void AddBytes(const void* Data, size_t Count) { Bytes.append(static_cast<const char*>(Data), Count); }
	void AddText(const std::string& Text)
	{
		Add(static_cast<uint32>(Text.size()));
		AddBytes(Text.data(), Text.size());
	}

	std::string Bytes;
};

class FReader
{
public:
	FReader(const std::string& InBytes, size_t InEnd, const std::string& InFile)
		: Bytes(InBytes)
		, End(InEnd)
		, File(InFile)
	{
	}

	template<typename T>
	void Get(T& OutValue)
	{
		static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
		GetBytes(&OutValue, sizeof(T));
	}
	template<typename T>
	T Get()
	{
		T Value{};
		Get(Value);
		return Value;
	}
	void GetBytes(void* Out, size_t Count)
	{
		Require(Count);
		std::memcpy(Out, Bytes.data() + At, Count);
		At += Count;
	}
	std::string GetText()
	{
		std::string Text(CountOf(1), '\0');
		GetBytes(Text.data(), Text.size());
		return Text;
	}
	/** A number of things that take at least Size bytes each. */
	uint32 CountOf(size_t Size)
	{
		const uint32 Count = Get<uint32>();
		Require(static_cast<size_t>(Count) * Size);
		return Count;
	}
	void Require(size_t Count) const
	{
		if (End - At < Count)
		{
			Fail("is cut short");
		}
	}
	bool IsAtEnd() const { return At == End; }
	[[noreturn]] void Fail(const std::string& Why) const
	{
		throw FError({.Code = ErrorStateBroken, .Message = "the state of a frame " + Why, .File = File}, ExitFiles);
	}

private:
	const std::string& Bytes;
	const size_t End;
	const std::string& File;
	size_t At = 0;
};

/** Calls Field for each member; one list for writing and reading. */
template<typename TDesc, typename TFunction>
void ForEachField(TDesc& Desc, const TFunction& Field)
{
	Field(Desc.Flags);
	Field(Desc.ClearValue.ColorBinding);
	for (auto& Component : Desc.ClearValue.Value.Color)
	{
		Field(Component);
	}
	Field(Desc.ClearValue.Value.DSValue.Depth);
	Field(Desc.ClearValue.Value.DSValue.Stencil);
	Field(Desc.ExtData);
	Field(Desc.Extent.X);
	Field(Desc.Extent.Y);
	Field(Desc.Depth);
	Field(Desc.ArraySize);
	Field(Desc.NumMips);
	Field(Desc.NumSamples);
	Field(Desc.Dimension);
	Field(Desc.Format);
	Field(Desc.UAVFormat);
}

template<typename TRect, typename TFunction>
void ForEachCorner(TRect& Rect, const TFunction& Field)
{
	Field(Rect.Min.X);
	Field(Rect.Min.Y);
	Field(Rect.Max.X);
	Field(Rect.Max.Y);
}

/** Rows of texels, of every plane, mip and slice. Rect: only its texels, where there is one mip. */
template<typename TFunction>
void ForEachRow(FRHITexture& Texture, const FIntRect* Rect, const TFunction& Row)
{
	Texture.EnsureMemory();
	for (int32 Plane = 0; Plane < Texture.GetNumPlanes(); ++Plane)
	{
		const size_t TexelSize = GetTexelStorageInfo(Texture.GetStorage(Plane)).BytesPerTexel;
		for (int32 Mip = 0; Mip < static_cast<int32>(Texture.GetNumMips()); ++Mip)
		{
			const FTextureMipLayout& Layout = Texture.GetMipLayout(Mip, Plane);
			FIntRect Texels(0, 0, Layout.SizeX, Layout.SizeY);
			if (Rect != nullptr && Texture.GetNumMips() == 1)
			{
				Texels.Clip(*Rect);
			}
			for (int32 Z = 0; Texels.Width() > 0 && Z < Layout.SizeZ; ++Z)
			{
				for (int32 Y = Texels.Min.Y; Y < Texels.Max.Y; ++Y)
				{
					Row(Texture.GetTexel(Texels.Min.X, Y, Mip, Z, Plane),
						static_cast<size_t>(Texels.Width()) * TexelSize);
				}
			}
		}
	}
}

void WriteProjection(FWriter& Writer, const FSceneViewProjectionData& Projection)
{
	for (int32 Axis = 0; Axis < 3; ++Axis)
	{
		Writer.Add(Projection.ViewOrigin[Axis]);
	}
	for (const FMatrix* Matrix : {&Projection.ViewRotationMatrix, &Projection.ProjectionMatrix})
	{
		Writer.AddBytes(Matrix->M, sizeof(Matrix->M));
	}
	ForEachCorner(Projection.GetViewRect(), [&](const auto& Value) { Writer.Add(Value); });
}

FSceneViewProjectionData ReadProjection(FReader& Reader)
{
	FSceneViewProjectionData Projection;
	for (int32 Axis = 0; Axis < 3; ++Axis)
	{
		Reader.Get(Projection.ViewOrigin[Axis]);
	}
	for (FMatrix* Matrix : {&Projection.ViewRotationMatrix, &Projection.ProjectionMatrix})
	{
		Reader.GetBytes(Matrix->M, sizeof(Matrix->M));
	}
	FIntRect Rect;
	ForEachCorner(Rect, [&](auto& Value) { Reader.Get(Value); });
	Projection.SetViewRectangle(Rect);
	return Projection;
}

void WriteTexture(FWriter& Writer, const FHistoryTexture& Kept, bool bViewRectOnly)
{
	FRHITexture& Texture = *Kept.Target->GetRHI();
	ForEachCorner(Kept.ViewRect, [&](const auto& Value) { Writer.Add(Value); });
	ForEachField(Texture.GetDesc(), [&](const auto& Value) { Writer.Add(Value); });
	Writer.Add(static_cast<uint32>(Texture.GetStorage()));
	Writer.Add(static_cast<uint64>(Texture.GetSizeInBytes()));
	ForEachRow(Texture, bViewRectOnly ? &Kept.ViewRect : nullptr,
		[&](const uint8* Row, size_t Count) { Writer.AddBytes(Row, Count); });
}

/** Whether it is one that a frame can leave, whatever the bytes say. */
bool IsTexture(const FRHITextureDesc& Desc, const FIntRect& Rect)
{
	const bool bInside = 0 <= Rect.Min.X && Rect.Min.X <= Rect.Max.X && Rect.Max.X <= Desc.Extent.X &&
						 0 <= Rect.Min.Y && Rect.Min.Y <= Rect.Max.Y && Rect.Max.Y <= Desc.Extent.Y;
	const bool bUAV =
		Desc.UAVFormat == PF_Unknown || (Desc.UAVFormat < PF_MAX && GPixelFormats[Desc.UAVFormat].Supported);
	return Desc.IsValid() && bInside && bUAV && Desc.Dimension <= ETextureDimension::TextureCubeArray &&
		   Desc.ClearValue.ColorBinding <= EClearBinding::EDepthStencilBound;
}

FHistoryTexture ReadHistoryTexture(FReader& Reader, const std::string& Name)
{
	FHistoryTexture Kept;
	ForEachCorner(Kept.ViewRect, [&](auto& Value) { Reader.Get(Value); });
	FRHITextureDesc Desc;
	ForEachField(Desc, [&](auto& Value) { Reader.Get(Value); });
	const uint32 Storage = Reader.Get<uint32>();
	const uint64 Size = Reader.Get<uint64>();
	if (!IsTexture(Desc, Kept.ViewRect))
	{
		Reader.Fail("has an impossible texture");
	}
	if (FRHITexture::ComputeSize(Desc) != Size || static_cast<uint32>(GetTexelStorage(Desc)) != Storage)
	{
		Reader.Fail("was written under another r.Drydock.Storage");
	}
	// No memory is taken for texels that are not there. This counts those of the first plane and mip.
	const size_t NumTexels = static_cast<size_t>(Desc.Extent.X) * static_cast<size_t>(Desc.Extent.Y) * Desc.Depth *
							 static_cast<size_t>(Desc.GetNumSlices());
	Reader.Require(NumTexels * GetTexelStorageInfo(GetTexelStorage(Desc)).BytesPerTexel);
	Kept.Target = GRenderTargetPool.FindFreeElement(Desc, Intern(Name));
	ForEachRow(*Kept.Target->GetRHI(), nullptr, [&](uint8* Row, size_t Count) { Reader.GetBytes(Row, Count); });
	return Kept;
}

void WriteBuffer(FWriter& Writer, const FRDGPooledBuffer& Buffer)
{
	Writer.Add(Buffer.Desc.Usage);
	Writer.Add(Buffer.Desc.BytesPerElement);
	Writer.Add(Buffer.Desc.NumElements);
	Writer.AddBytes(Buffer.GetRHI()->GetData(), Buffer.GetSize());
}

TRefCountPtr<FRDGPooledBuffer> ReadBuffer(FReader& Reader, const std::string& Name)
{
	FRDGBufferDesc Desc;
	Reader.Get(Desc.Usage);
	Reader.Get(Desc.BytesPerElement);
	Reader.Get(Desc.NumElements);
	const size_t Size = static_cast<size_t>(Desc.BytesPerElement) * Desc.NumElements;
	if (Size == 0 || Size > std::numeric_limits<uint32>::max())
	{
		Reader.Fail("has an impossible buffer");
	}
	Reader.Require(Size);
	const TRefCountPtr<FRDGPooledBuffer> Buffer = GRenderGraphResourcePool.FindFreeBuffer(Desc, Intern(Name));
	Reader.GetBytes(Buffer->GetRHI()->GetData(), Desc.GetSize());
	return Buffer;
}

/** Without the check at the end. */
std::string Pack(const std::vector<FViewHistory>& Views, bool bViewRectOnly)
{
	FWriter Writer;
	Writer.AddBytes(Magic, sizeof(Magic));
	Writer.Add(static_cast<uint32>(Views.size()));
	for (const FViewHistory& View : Views)
	{
		Writer.Add(static_cast<uint8>(View.bValid));
		Writer.Add(static_cast<uint8>(View.bHasCaches));
		Writer.Add(View.FrameNumber);
		Writer.Add(static_cast<uint8>(View.Projection.has_value()));
		if (View.Projection)
		{
			WriteProjection(Writer, *View.Projection);
		}
		Writer.Add(View.Jitter.X);
		Writer.Add(View.Jitter.Y);
		Writer.Add(View.PreExposure);
		Writer.Add(static_cast<uint32>(View.Textures.size()));
		for (const auto& [Name, Texture] : View.Textures)
		{
			Writer.AddText(Name);
			WriteTexture(Writer, Texture, bViewRectOnly);
		}
		Writer.Add(static_cast<uint32>(View.Buffers.size()));
		for (const auto& [Name, Buffer] : View.Buffers)
		{
			Writer.AddText(Name);
			WriteBuffer(Writer, *Buffer);
		}
	}
	return Writer.Bytes;
}

std::string FingerprintOf(const char* Bytes, size_t Count)
{
	FFingerprint Fingerprint;
	Fingerprint.Add(Bytes, Count);
	return Fingerprint.Get();
}

} // namespace

std::string PackViewStates(const std::vector<FViewHistory>& Views)
{
	const std::string Bytes = Pack(Views, false);
	return Bytes + FingerprintOf(Bytes.data(), Bytes.size());
}

std::string FingerprintViewStates(const std::vector<FViewHistory>& Views)
{
	const std::string Bytes = Pack(Views, true);
	return FingerprintOf(Bytes.data(), Bytes.size());
}

std::vector<FViewHistory> UnpackViewStates(const std::string& Bytes, const std::string& File)
{
	constexpr size_t FingerprintSize = 32;
	const size_t End = Bytes.size() < FingerprintSize ? 0 : Bytes.size() - FingerprintSize;
	FReader Reader(Bytes, End, File);
	char Begin[sizeof(Magic)];
	Reader.GetBytes(Begin, sizeof(Begin));
	if (std::memcmp(Begin, Magic, sizeof(Magic)) != 0)
	{
		Reader.Fail("is not valid, or was written by another version of drydock");
	}
	if (Bytes.compare(End, FingerprintSize, FingerprintOf(Bytes.data(), End)) != 0)
	{
		Reader.Fail("is damaged");
	}
	std::vector<FViewHistory> Views(Reader.CountOf(1));
	for (FViewHistory& View : Views)
	{
		View.bValid = Reader.Get<uint8>() != 0;
		View.bHasCaches = Reader.Get<uint8>() != 0;
		Reader.Get(View.FrameNumber);
		if (Reader.Get<uint8>() != 0)
		{
			View.Projection = ReadProjection(Reader);
		}
		Reader.Get(View.Jitter.X);
		Reader.Get(View.Jitter.Y);
		Reader.Get(View.PreExposure);
		for (uint32 Count = Reader.CountOf(1); Count > 0; --Count)
		{
			const std::string Name = Reader.GetText();
			View.Textures[Name] = ReadHistoryTexture(Reader, Name);
		}
		for (uint32 Count = Reader.CountOf(1); Count > 0; --Count)
		{
			const std::string Name = Reader.GetText();
			View.Buffers[Name] = ReadBuffer(Reader, Name);
		}
	}
	if (!Reader.IsAtEnd())
	{
		Reader.Fail("is longer than its header states");
	}
	return Views;
}

} // namespace Drydock
