#include "core/images/image_bytes.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace unprojector::images {

ImageBytes::ImageBytes(Read read, Seek seek, std::optional<std::uint64_t> size)
    : m_read(std::move(read)), m_seek(std::move(seek)), m_size(size), m_kept(kFirst, '\0')
{
    m_kept.resize(m_read(m_kept.data(), kFirst));
    m_sourceAt = m_kept.size();
}

std::size_t ImageBytes::readSome(char *target, std::size_t count)
{
    std::size_t done = 0;
    if (m_at < m_kept.size()) {
        done = std::min(count, m_kept.size() - static_cast<std::size_t>(m_at));
        std::memcpy(target, m_kept.data() + m_at, done);
        m_at += done;
    }
    if (done == count)
        return done;
    if (m_at != m_sourceAt) {
        if (!m_seek(m_at))
            return done;
        m_sourceAt = m_at;
    }
    const std::size_t more = m_read(target + done, count - done);
    m_sourceAt += more;
    m_at += more;
    return done + more;
}

void ImageBytes::allowPositions()
{
    if (m_size)
        return;
    constexpr std::size_t kPortion = std::size_t{1} << 20;
    for (bool isEnd = false; !isEnd;) {
        const std::size_t before = m_kept.size();
        m_kept.resize(before + kPortion);
        m_kept.resize(before + m_read(m_kept.data() + before, kPortion));
        isEnd = m_kept.size() < before + kPortion;
    }
    m_sourceAt = m_kept.size();
    m_size = m_kept.size();
}

} // namespace unprojector::images
